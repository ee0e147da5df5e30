using Engraver.App.Texts;
using Engraver.Core.Languages;

namespace Engraver.App.FileDialogs;

/// <summary>The places at the left of the dialog. Each folder is listed once.</summary>
internal static class FilePlaces
{
    private const int MaxRecentFolders = 5;
    private const int MaxRecentFiles = 5;

    /// <summary>For a thread of the pool: checking that a folder exists may take a while.</summary>
    /// <param name="drawing">Path of the open drawing; null for none.</param>
    /// <param name="recent">Paths of the recent drawings.</param>
    /// <param name="fits">Whether a recent file is one of the requested kind.</param>
    public static IReadOnlyList<FilePlace> Find(string? drawing, IReadOnlyList<string> recent, Func<string, bool> fits)
    {
        var places = new List<FilePlace>();
        Add(Text.Get("Files.Home"), FolderOf(Environment.SpecialFolder.UserProfile));
        Add(Text.Get("Files.Desktop"), FolderOf(Environment.SpecialFolder.DesktopDirectory));
        Add(Text.Get("Files.Documents"), FolderOf(Environment.SpecialFolder.MyDocuments));
        Add(Text.Get("Files.DrawingFolder"), drawing is null ? null : Path.GetDirectoryName(Path.GetFullPath(drawing)));
        Add(Text.Get("Files.Samples"), SampleFolder.Find());
        foreach (var drive in Drives()) Add(NameOf(drive), drive);
        foreach (var folder in recent.Select(Path.GetDirectoryName).Distinct().Take(MaxRecentFolders)) Add(NameOf(folder!), folder);
        places.AddRange(recent.Where(file => fits(file) && File.Exists(file)).Take(MaxRecentFiles).Select(file => new FilePlace(TextCatalogue.Fact(Path.GetFileName(file)), file, true)));
        return places;

        void Add(string name, string? folder)
        {
            if (folder is { Length: > 0 } && places.All(place => place.Path != folder) && Directory.Exists(folder)) places.Add(new FilePlace(name, folder, false));
        }
    }

    private static string FolderOf(Environment.SpecialFolder folder) => Environment.GetFolderPath(folder, Environment.SpecialFolderOption.DoNotVerify);

    /// <summary>Mounted drives, and the root.</summary>
    private static IEnumerable<string> Drives()
    {
        try
        {
            return DriveInfo.GetDrives().Select(drive => drive.Name).Where(IsUserDrive).Distinct().Order(StringComparer.Ordinal);
        }
        catch (Exception unknown) when (unknown is IOException or UnauthorizedAccessException)
        {
            return [];
        }
    }

    private static bool IsUserDrive(string drive) => OperatingSystem.IsWindows() || drive == "/" || ((string[])["/media/", "/mnt/", "/run/media/", "/Volumes/"]).Any(under => drive.StartsWith(under, StringComparison.Ordinal));

    private static string NameOf(string folder) => folder == "/" ? Text.Get("Files.Computer") : Path.GetFileName(Path.TrimEndingDirectorySeparator(folder)) is { Length: > 0 } name ? TextCatalogue.Fact(name) : folder;
}
