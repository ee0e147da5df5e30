namespace Engraver.Workbench.Files;

/// <summary>Where the operator's own files are: one folder for the program in the user's data.</summary>
public static class UserFiles
{
    public static string Folder
    {
        get
        {
            var data = Environment.GetFolderPath(Environment.SpecialFolder.LocalApplicationData, Environment.SpecialFolderOption.DoNotVerify);
            return Path.Combine(data.Length > 0 ? data : Path.GetTempPath(), "CncEngraver");
        }
    }

    /// <summary>The operator's aliases; the file need not be there.</summary>
    public static string Aliases => Path.Combine(Folder, "engraver.pgp");

    /// <summary>What the desktop remembers.</summary>
    public static string DesktopSettingsFile => Path.Combine(Folder, "desktop.json");
}
