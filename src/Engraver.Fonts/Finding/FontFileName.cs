namespace Engraver.Fonts.Finding;

/// <summary>Names of font files as drawings state them: with a folder of any system, or without an extension.</summary>
internal static class FontFileName
{
    /// <summary>What a name without extension may be. LibreCAD and Hershey fonts are found only by their whole name, because some of them are named as
    /// fonts of AutoCAD.</summary>
    private static readonly string[] s_implied = [".shx", ".ttf", ".otf", ".ttc", ".otc"];

    private static readonly string[] s_known = [.. s_implied, ".lff", ".jhf"];

    /// <summary>Without the folder.</summary>
    public static string Of(string path) => path.Trim().Split('/', '\\')[^1];

    public static bool HasKnownExtension(string name) => s_known.Contains(Path.GetExtension(name), StringComparer.OrdinalIgnoreCase);

    /// <summary>The files that a name stands for, the first choice first.</summary>
    public static IEnumerable<string> Meant(string name)
    {
        var file = Of(name);
        return file.Length == 0 ? [] : HasKnownExtension(file) ? [file] : s_implied.Select(extension => file + extension);
    }
}
