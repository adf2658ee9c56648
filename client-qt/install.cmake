# The desktop client as the desktop finds it: menu entry, file types, icon, man page. After an installation outside a
# package run "update-mime-database PREFIX/share/mime" and "update-desktop-database PREFIX/share/applications".
install(TARGETS tedit-qt RUNTIME DESTINATION bin)
install(FILES client-qt/resources/org.tedit.TEdit.desktop DESTINATION share/applications)
install(FILES client-qt/resources/org.tedit.TEdit.xml DESTINATION share/mime/packages)
install(FILES client-qt/resources/org.tedit.TEdit.metainfo.xml DESTINATION share/metainfo)
install(FILES client-qt/resources/tedit.svg DESTINATION share/icons/hicolor/scalable/apps RENAME org.tedit.TEdit.svg)
install(FILES docs/man/tedit-qt.1 DESTINATION share/man/man1)
