# Writes a file's bytes as numbers between commas, for an array in C++. Runs with: from, to.
file(READ "${from}" bytes HEX)
string(REGEX REPLACE "(................................)" "\\1\n" bytes "${bytes}")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
file(WRITE "${to}" "${bytes}")
