using Engraver.Core.Geometry;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>Asks for the name of a file. It may be quoted, relative to the home folder (<c>~/plate.dxf</c>), or a file URL; a desktop shows its file dialog
/// instead.</summary>
/// <param name="Wanted">Which files fit.</param>
public sealed record FilePrompt(string Instruction, FileWanted Wanted) : ValuePrompt<string>(Instruction)
{
    public override bool TakesSpaces => true;

    public override FileWanted? File => Wanted;

    public override Reading<string> Read(string typed, Point2D lastPoint) => new Reading<string>.Value(TypedFileName.Read(typed));
}

/// <summary>The files that fit a prompt.</summary>
/// <param name="Kind">Kind of file, an internal key (<c>drawing</c>, <c>script</c>); the last folder is remembered for each.</param>
/// <param name="Writes">The file is written and need not exist.</param>
/// <param name="Endings">File extensions with their dots, the default first; empty if every file fits.</param>
public sealed record FileWanted(string Kind, bool Writes, params IReadOnlyList<string> Endings)
{
    public const string Drawing = "drawing";

    /// <summary>Full path suggested by a dialog; null for none.</summary>
    public string? Suggested { get; init; }

    /// <summary>Enter alone is allowed: the result is shown in the command window and not written.</summary>
    public bool MayShow { get; init; }

    /// <summary>The name with the default extension, unless it already has a matching one or is a stream.</summary>
    public string WithEnding(string name)
    {
        ArgumentNullException.ThrowIfNull(name);
        return Endings.Count == 0 || Fits(name) || Path.EndsInDirectorySeparator(name) || FileKind.IsStream(name) ? name : name.TrimEnd('.') + Endings[0];
    }

    /// <summary>True for a file with one of the extensions.</summary>
    public bool Fits(string name) => Endings.Count == 0 || Endings.Any(ending => name.EndsWith(ending, StringComparison.OrdinalIgnoreCase));
}

/// <summary>File names as typed or pasted.</summary>
public static class TypedFileName
{
    /// <summary>Removes quotes, replaces <c>~</c> by the home folder and a file URL by its path.</summary>
    public static string Read(string typed)
    {
        ArgumentNullException.ThrowIfNull(typed);
        var name = Unquoted(typed.Trim());
        if (name.StartsWith("file://", StringComparison.OrdinalIgnoreCase) && Uri.TryCreate(name, UriKind.Absolute, out var address) && address.IsFile) return address.LocalPath;
        return name == "~" || name.StartsWith("~/", StringComparison.Ordinal) || name.StartsWith("~\\", StringComparison.Ordinal) ? AtHome(name) : name;
    }

    /// <summary>The path in the form that a prompt reads back unchanged.</summary>
    public static string Write(string path) => Read(path) == path && path.Trim() == path ? path : $"\"{path}\"";

    /// <summary>True for a text that can only start a file name: a quote, an absolute path, a path from the home folder, a file URL. No command, option or
    /// point starts like this.</summary>
    public static bool IsPath(string typed)
    {
        ArgumentNullException.ThrowIfNull(typed);
        return typed is ['"' or '/' or '\\', ..] or ['~', '/' or '\\', ..] or [_, ':', '/' or '\\', ..] || typed.StartsWith("file:", StringComparison.OrdinalIgnoreCase);
    }

    private static string Unquoted(string name) => name is ['"', .., '"'] or ['\'', .., '\''] ? name[1..^1] : name;

    private static string AtHome(string name)
    {
        var home = Environment.GetFolderPath(Environment.SpecialFolder.UserProfile, Environment.SpecialFolderOption.DoNotVerify);
        return name.Length <= 2 ? home : Path.Combine(home, name[2..]);
    }
}
