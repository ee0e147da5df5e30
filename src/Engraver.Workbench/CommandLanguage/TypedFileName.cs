namespace Engraver.Workbench.CommandLanguage;

/// <summary>File names as typed or pasted.</summary>
public static class TypedFileName
{
    /// <summary>Removes quotes, replaces <c>~</c> by the home folder and a file URL by its path.</summary>
    public static string Parse(string typed)
    {
        ArgumentNullException.ThrowIfNull(typed);
        var name = Unquoted(typed.Trim());
        if (name.StartsWith("file://", StringComparison.OrdinalIgnoreCase) && Uri.TryCreate(name, UriKind.Absolute, out var address) && address.IsFile) return address.LocalPath;
        return name == "~" || name.StartsWith("~/", StringComparison.Ordinal) || name.StartsWith("~\\", StringComparison.Ordinal) ? ExpandHome(name) : name;
    }

    /// <summary>The path in the form that a prompt reads back unchanged.</summary>
    public static string Format(string path) => Parse(path) == path && path.Trim() == path ? path : $"\"{path}\"";

    /// <summary>True for a text that can only start a file name: a quote, an absolute path, a path from the home folder, a file URL. No command, option or
    /// point starts like this.</summary>
    public static bool IsPath(string typed)
    {
        ArgumentNullException.ThrowIfNull(typed);
        return typed is ['"' or '/' or '\\', ..] or ['~', '/' or '\\', ..] or [_, ':', '/' or '\\', ..] || typed.StartsWith("file:", StringComparison.OrdinalIgnoreCase);
    }

    private static string Unquoted(string name) => name is ['"', .., '"'] or ['\'', .., '\''] ? name[1..^1] : name;

    private static string ExpandHome(string name)
    {
        var home = Environment.GetFolderPath(Environment.SpecialFolder.UserProfile, Environment.SpecialFolderOption.DoNotVerify);
        return name.Length <= 2 ? home : Path.Combine(home, name[2..]);
    }
}
