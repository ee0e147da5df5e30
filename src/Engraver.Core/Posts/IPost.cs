using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Toolpaths;

namespace Engraver.Core.Posts;

/// <summary>One format in which a job is written: an entry of the table of posts (ADR 9).</summary>
public interface IPost
{
    /// <summary>The name as in <c>--target</c>.</summary>
    string Name { get; }

    /// <summary>Description of the output, in one line without a full stop.</summary>
    string Summary { get; }

    /// <summary>Extension of such files, with the point.</summary>
    string Ending { get; }

    /// <summary>The input of the post.</summary>
    PostGeometry Geometry { get; }

    /// <summary>The style of the motion program from which it is written; null when it is written from the path in millimetres, independent of the
    /// machine.</summary>
    MotionStyle? Motion { get; }

    /// <summary>Options in addition to the settings of the job; may be empty.</summary>
    IReadOnlyList<PostOption> Options { get; }

    PostText Write(PostRequest request);

    /// <summary>The findings of <see cref="Write"/>. A post that can determine them without writing overrides this.</summary>
    IReadOnlyList<Diagnostic> Findings(PostRequest request) => Write(request).Diagnostics;
}

/// <summary>The input of a post.</summary>
public enum PostGeometry
{
    /// <summary>A motion program in counts, made for the machine of the profile.</summary>
    Program,

    /// <summary>Curves as drawn, millimetres: an ellipse stays an ellipse.</summary>
    Curves,

    /// <summary>Lines, arcs and circles, millimetres; those of an ellipse or spline within the curve tolerance.</summary>
    LinesAndArcs,
}

/// <summary>One option of a post.</summary>
/// <param name="Name">Name without dashes.</param>
/// <param name="Argument">Placeholder of the value in a help text.</param>
/// <param name="Summary">Description in one sentence.</param>
/// <param name="Default">The value when none is given.</param>
/// <param name="Form">Form of a value: "a whole number from 1 to 9".</param>
/// <param name="Takes">True for a valid value.</param>
public sealed record PostOption(string Name, string Argument, string Summary, string Default, string Form, Func<string, bool> Takes);

/// <summary>A job to write.</summary>
/// <param name="Path">Ordered strokes, millimetres of the drawing: curves as drawn for a post that requires them, otherwise lines and arcs.</param>
/// <param name="Program">Motion program in the style that the post requires; null for a post that needs no program.</param>
/// <param name="SourceOf">Position of a drawing entity in its file, for diagnostics; null when unknown.</param>
/// <param name="Options">Values by name, each valid for its option; omitted options have their default.</param>
public sealed record PostRequest(Toolpath Path, MotionProgram? Program, Func<int, SourceRef>? SourceOf, IReadOnlyDictionary<string, string> Options)
{
    /// <summary>The machine that runs it: feeds, tool drive, spindle. The motion program also contains it.</summary>
    public required MachineProfile Machine { get; init; }

    /// <summary>Largest distance from the drawing where the format of the post does not have the drawn curve, millimetres, above 0.</summary>
    public required double MaxErrorMm { get; init; }

    /// <summary>The value of an option.</summary>
    public string Value(PostOption option)
    {
        ArgumentNullException.ThrowIfNull(option);
        return Options.TryGetValue(option.Name, out var value) ? value : option.Default;
    }
}

/// <summary>A job as text: one or more parts that are loaded and run one after the other without moving the machine in between.</summary>
/// <param name="Chunks">Each ends with a line end (LF); empty when the job cannot be written, and the diagnostics state why.</param>
/// <param name="Diagnostics">Deviations from the requested output.</param>
public sealed record PostText(IReadOnlyList<string> Chunks, IReadOnlyList<Diagnostic> Diagnostics)
{
    public string Text => string.Concat(Chunks);

    /// <summary>The line of the whole text, from 1, that commands each segment of the motion program; empty when not requested.</summary>
    public IReadOnlyList<int> SegmentLines { get; init; } = [];

    /// <summary>Predicted machine position after each block; null for a format without significant rounding.</summary>
    public PostForecast? Forecast { get; init; }
}
