using Engraver.Core.Geometry;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>Asks for the name of a file. It may be typed with quotes round it, from the home folder (<c>~/plate.dxf</c>), or as a file address; a desktop
/// with a window shows its file dialog instead.</summary>
/// <param name="Wanted">Which files fit.</param>
public sealed record FilePrompt(string Instruction, FileWanted Wanted) : ValuePrompt<string>(Instruction)
{
    public override bool TakesSpaces => true;

    public override FileWanted? File => Wanted;

    public override Reading<string> Read(string typed, Point2D lastPoint) => new Reading<string>.Value(TypedFileName.Read(typed));
}

/// <summary>The files that fit a prompt.</summary>
/// <param name="Kind">What they are, by a word of the program (<c>drawing</c>, <c>script</c>); the folder that was used last is kept for each.</param>
/// <param name="Writes">The file is written, and may have to be made.</param>
/// <param name="Endings">With their dots, the usual one first; none where every file fits.</param>
public sealed record FileWanted(string Kind, bool Writes, params IReadOnlyList<string> Endings)
{
    public const string Drawing = "drawing";

    /// <summary>Full path that a dialog offers; null for none.</summary>
    public string? Suggested { get; init; }

    /// <summary>Enter alone is an answer: the result is shown in the command window and written nowhere.</summary>
    public bool MayShow { get; init; }

    /// <summary>The name with the usual ending, unless it has one that fits or a stream stands there.</summary>
    public string WithEnding(string name)
    {
        ArgumentNullException.ThrowIfNull(name);
        return Endings.Count == 0 || Fits(name) || Path.EndsInDirectorySeparator(name) || FileKind.IsStream(name) ? name : name.TrimEnd('.') + Endings[0];
    }

    /// <summary>True for a file of one of the endings.</summary>
    public bool Fits(string name) => Endings.Count == 0 || Endings.Any(ending => name.EndsWith(ending, StringComparison.OrdinalIgnoreCase));
}

/// <summary>The name of a file as people type and paste it.</summary>
public static class TypedFileName
{
    /// <summary>The name without the quotes round it, <c>~</c> as the home folder, a file address as its path.</summary>
    public static string Read(string typed)
    {
        ArgumentNullException.ThrowIfNull(typed);
        var name = Unquoted(typed.Trim());
        if (name.StartsWith("file://", StringComparison.OrdinalIgnoreCase) && Uri.TryCreate(name, UriKind.Absolute, out var address) && address.IsFile) return address.LocalPath;
        return name == "~" || name.StartsWith("~/", StringComparison.Ordinal) || name.StartsWith("~\\", StringComparison.Ordinal) ? AtHome(name) : name;
    }

    /// <summary>The path as it has to be written at a prompt, so that it is read back as it is.</summary>
    public static string Write(string path) => Read(path) == path && path.Trim() == path ? path : $"\"{path}\"";

    /// <summary>True for what can only be the beginning of a file's name: a quote, a path from the root or from the home folder, a file address. No
    /// command, option or point begins so.</summary>
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
