using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Toolpaths;

namespace Engraver.Core.Posts;

/// <summary>One format in which a job is written down: an entry of the table of posts (ADR 9).</summary>
public interface IPost
{
    /// <summary>As <c>--target</c> has it.</summary>
    string Name { get; }

    /// <summary>What is written, in one line without a full stop.</summary>
    string Summary { get; }

    /// <summary>How the names of such files end, with the point.</summary>
    string Ending { get; }

    /// <summary>What it is written from.</summary>
    PostGeometry Geometry { get; }

    /// <summary>The style of the motion program that it is written from; null when it is written from the path in millimetres, whatever the machine.</summary>
    MotionStyle? Motion { get; }

    /// <summary>What may be said beside the settings of the job; empty for nothing.</summary>
    IReadOnlyList<PostOption> Options { get; }

    PostText Write(PostRequest request);

    /// <summary>What <see cref="Write"/> would find. A post that knows it without writing says so at once.</summary>
    IReadOnlyList<Diagnostic> Findings(PostRequest request) => Write(request).Diagnostics;
}

/// <summary>What a post is written from.</summary>
public enum PostGeometry
{
    /// <summary>A motion program in counts, made for the machine of the profile.</summary>
    Program,

    /// <summary>Curves as they were drawn, millimetres: an ellipse is an ellipse.</summary>
    Curves,

    /// <summary>Lines, arcs and circles, millimetres; those of an ellipse or spline within the curve tolerance.</summary>
    LinesAndArcs,
}

/// <summary>One thing that a post lets its user choose.</summary>
/// <param name="Name">Without dashes.</param>
/// <param name="Argument">What stands for the value in a help text.</param>
/// <param name="Summary">In one sentence.</param>
/// <param name="Default">The value when none is given.</param>
/// <param name="Form">What a value looks like: "a whole number from 1 to 9".</param>
/// <param name="Takes">Whether a value is one.</param>
public sealed record PostOption(string Name, string Argument, string Summary, string Default, string Form, Func<string, bool> Takes);

/// <summary>A job that is to be written.</summary>
/// <param name="Path">Ordered strokes, millimetres of the drawing: curves as they were drawn for a post that asks for them, otherwise lines and arcs.</param>
/// <param name="Program">In the style that the post asks for; null for a post that asks for none.</param>
/// <param name="SourceOf">Where a drawing entity stands in its file, for diagnostics; null for nowhere.</param>
/// <param name="Options">By name, each one that its option takes; those left out have their default.</param>
public sealed record PostRequest(Toolpath Path, MotionProgram? Program, Func<int, SourceRef>? SourceOf, IReadOnlyDictionary<string, string> Options)
{
    /// <summary>The machine that runs it: feeds, tool drive, spindle. A post that is written from a motion program finds it there too.</summary>
    public MachineProfile Machine { get; init; } = MachineProfile.Default;

    /// <summary>How far a post may leave what is drawn where its form has no such curve, millimetres, above 0.</summary>
    public double MaxErrorMm { get; init; } = 0.001;

    /// <summary>The value of an option.</summary>
    public string Value(PostOption option)
    {
        ArgumentNullException.ThrowIfNull(option);
        return Options.TryGetValue(option.Name, out var value) ? value : option.Default;
    }
}

/// <summary>A job as text: one or more parts that are loaded and run one after the other without moving the machine in between.</summary>
/// <param name="Chunks">Each ends with a line end (LF); none when the job cannot be written, and the diagnostics say why.</param>
/// <param name="Diagnostics">What had to be done otherwise than asked.</param>
public sealed record PostText(IReadOnlyList<string> Chunks, IReadOnlyList<Diagnostic> Diagnostics)
{
    public string Text => string.Concat(Chunks);

    /// <summary>The line of the whole text, from 1, that commands each segment of the motion program; empty where nobody asks for it.</summary>
    public IReadOnlyList<int> SegmentLines { get; init; } = [];

    /// <summary>Where the machine will be after each block; null for a form that loses nothing worth telling.</summary>
    public PostForecast? Forecast { get; init; }
}
