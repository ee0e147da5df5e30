using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Toolpaths;

namespace Engraver.Core.Posts;

/// <summary>A job to write.</summary>
/// <param name="Path">Ordered strokes, millimetres of the drawing: curves as drawn for a post that requires them, otherwise lines and arcs.</param>
/// <param name="Program">Motion program in the style that the post requires; null for a post that needs no program.</param>
/// <param name="SourceOf">Position of a drawing entity in its file, for diagnostics; null when unknown.</param>
/// <param name="Options">Values by name, each valid for its option; omitted options have their default.</param>
public sealed record PostRequest(Toolpath Path, MotionProgram? Program, Func<int, SourceRef>? SourceOf, IReadOnlyDictionary<string, string> Options)
{
    /// <summary>The machine that runs it: feeds, tool drive, spindle. The motion program also contains it.</summary>
    public required MachineProfile Machine { get; init; }

    /// <summary>The operations of the strokes; null for a job without operations.</summary>
    public PostOperations? Operations { get; init; }

    /// <summary>Largest distance from the drawing where the format of the post does not have the drawn curve, millimetres, above 0.</summary>
    public required double MaxErrorMm { get; init; }

    /// <summary>The value of an option.</summary>
    public string Value(PostOption option)
    {
        ArgumentNullException.ThrowIfNull(option);
        return Options.TryGetValue(option.Name, out var value) ? value : option.Default;
    }
}
