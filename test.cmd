@echo off
rem Builds everything and runs every test on Windows.
rem   --full           every combination and the large numbers of seeds
rem   --update-golden  writes the expected files
setlocal
cd /d "%~dp0"
if "%~1"=="--full" set "ENGRAVER_FULL=1"
if "%~1"=="--update-golden" set "ENGRAVER_UPDATE_GOLDEN=1"
dotnet build CncEngraver.sln -c Release -v quiet -nologo || exit /b 1
dotnet test CncEngraver.sln -c Release --no-build -nologo -m:1
exit /b %errorlevel%
