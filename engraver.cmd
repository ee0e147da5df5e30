@echo off
rem Runs the console runner on Windows, or the desktop with the verb desktop. Builds first (fast if nothing has changed).
setlocal
set "root=%~dp0"
set "run=%root%artifacts\run"
if not exist "%run%" mkdir "%run%"
call :build engraver Engraver.Cli || exit /b 70
if /i "%~1"=="desktop" (
  call :build desktop Engraver.App || exit /b 70
)
dotnet "%run%\engraver\engraver.dll" %*
exit /b %errorlevel%

:build
dotnet publish "%root%src\%2\%2.csproj" -c Release -r win-x64 --no-self-contained -p:PublishReadyToRun=true -o "%run%\%1" -v quiet -nologo >"%run%\%1.log" 2>&1
if errorlevel 1 (
  type "%run%\%1.log" 1>&2
  exit /b 1
)
exit /b 0
