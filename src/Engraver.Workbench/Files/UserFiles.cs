namespace Engraver.Workbench.Files;

/// <summary>Paths of the operator's files in the user's data folder.</summary>
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

    /// <summary>The operator's aliases; the file need not exist.</summary>
    public static string Aliases => Path.Combine(Folder, "engraver.pgp");

    /// <summary>Templates of operations, NAME.operations.json; the folder need not exist.</summary>
    public static string Templates => Path.Combine(Folder, "templates");

    /// <summary>The counters of serial texts (docs/serial-text.md).</summary>
    /// <param name="folder">The data folder.</param>
    public static string CountersIn(string folder) => Path.Combine(folder, "counters", "counters.json");

    /// <summary>The persistent settings of the desktop.</summary>
    public static string DesktopSettingsFile => Path.Combine(Folder, "desktop.json");
}
