# The desktop client as the desktop finds it: menu entry, file types, icon, man page. After an installation outside a
# package run "update-mime-database PREFIX/share/mime" and "update-desktop-database PREFIX/share/applications".
install(TARGETS tedit-qt tedit-pdf RUNTIME DESTINATION bin OPTIONAL)
tedit_say_left_out("$<TARGET_FILE:tedit-qt>" "tedit-qt, the window," tedit-qt)
tedit_install_along(tedit-qt share/applications client-qt/resources/org.tedit.TEdit.desktop)
tedit_install_along(tedit-qt share/mime/packages client-qt/resources/org.tedit.TEdit.xml)
tedit_install_along(tedit-qt share/metainfo client-qt/resources/org.tedit.TEdit.metainfo.xml)
tedit_install_along(tedit-qt share/icons/hicolor/scalable/apps client-qt/resources/tedit.svg RENAME org.tedit.TEdit.svg)
tedit_install_along(tedit-qt share/man/man1 docs/man/tedit-qt.1)
tedit_install_along(tedit-qt share/bash-completion/completions cli/completion.bash RENAME tedit-qt)
