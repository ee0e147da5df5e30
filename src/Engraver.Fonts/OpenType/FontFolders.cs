namespace Engraver.Fonts.OpenType;

/// <summary>The folders in which fonts are installed, and the font files there.</summary>
public static class FontFolders
{
    /// <summary>Ends circles of links.</summary>
    private const int MaxDepth = 16;

    private static readonly string[] s_extensions = [".ttf", ".otf", ".ttc", ".otc"];

    /// <summary>The usual folders of this system and of its user; those that do not exist are left out later.</summary>
    public static IReadOnlyList<string> Standard => OperatingSystem.IsWindows() ? Windows : OperatingSystem.IsMacOS() ? MacOS : Linux;

    internal static IReadOnlyList<string> Windows =>
        [Environment.GetFolderPath(Environment.SpecialFolder.Fonts), Path.Combine(Environment.GetFolderPath(Environment.SpecialFolder.LocalApplicationData), "Microsoft", "Windows", "Fonts")];

    internal static IReadOnlyList<string> MacOS => ["/System/Library/Fonts", "/Library/Fonts", Path.Combine(Home, "Library/Fonts")];

    internal static IReadOnlyList<string> Linux => ["/usr/share/fonts", "/usr/local/share/fonts", Path.Combine(Home, ".local/share/fonts"), Path.Combine(Home, ".fonts")];

    private static string Home => Environment.GetFolderPath(Environment.SpecialFolder.UserProfile);

    /// <summary>In the order of their names, so that the choice between equal fonts is always the same.</summary>
    public static IEnumerable<string> Files(IEnumerable<string> folders) => folders.SelectMany(folder => FilesIn(folder, isDeep: true)).Where(IsOutlineFile);

    /// <summary>All files of a folder, in the order of their names; none if it does not exist or cannot be read.</summary>
    /// <param name="isDeep">With those of the folders in it.</param>
    internal static IReadOnlyList<string> FilesIn(string folder, bool isDeep)
    {
        var options = new EnumerationOptions { RecurseSubdirectories = isDeep, MaxRecursionDepth = MaxDepth, IgnoreInaccessible = true };
        try
        {
            return Directory.Exists(folder) ? [.. Directory.EnumerateFiles(folder, "*", options).Order(StringComparer.Ordinal)] : [];
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return [];
        }
    }

    /// <summary>True if the extension is that of a TrueType or OpenType font.</summary>
    public static bool IsOutlineFile(string path) => s_extensions.Contains(Path.GetExtension(path), StringComparer.OrdinalIgnoreCase);
}
