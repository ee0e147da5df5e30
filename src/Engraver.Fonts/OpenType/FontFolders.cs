namespace Engraver.Fonts.OpenType;

/// <summary>The folders in which fonts are installed, and the font files there.</summary>
public static class FontFolders
{
    private static readonly string[] s_extensions = [".ttf", ".otf", ".ttc", ".otc"];

    /// <summary>The usual folders of a Linux system and of its user; those that do not exist are left out later.</summary>
    public static IReadOnlyList<string> Standard
    {
        get
        {
            var home = Environment.GetFolderPath(Environment.SpecialFolder.UserProfile);
            return ["/usr/share/fonts", "/usr/local/share/fonts", Path.Combine(home, ".local/share/fonts"), Path.Combine(home, ".fonts")];
        }
    }

    /// <summary>In the order of their names, so that the choice between equal fonts is always the same.</summary>
    public static IEnumerable<string> Files(IEnumerable<string> folders)
    {
        var options = new EnumerationOptions { RecurseSubdirectories = true, IgnoreInaccessible = true };
        return folders
            .Where(Directory.Exists)
            .SelectMany(folder => Directory.EnumerateFiles(folder, "*", options).Order(StringComparer.Ordinal))
            .Where(path => s_extensions.Contains(Path.GetExtension(path), StringComparer.OrdinalIgnoreCase));
    }
}
