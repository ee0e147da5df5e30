@echo off
rem The headless console runner on Windows: builds (quick when nothing changed), then runs.
setlocal
set "root=%~dp0"
set "out=%root%artifacts\run\engraver"
if not exist "%root%artifacts\run" mkdir "%root%artifacts\run"
dotnet publish "%root%src\Engraver.Cli\Engraver.Cli.csproj" -c Release -r win-x64 --no-self-contained -p:PublishReadyToRun=true -o "%out%" -v quiet -nologo >"%root%artifacts\run\build.log" 2>&1
if errorlevel 1 (
  type "%root%artifacts\run\build.log" 1>&2
  exit /b 70
)
dotnet "%out%\engraver.dll" %*
exit /b %errorlevel%
