using System.Globalization;
using Engraver.Core.Machines;
using Engraver.Core.Posts;
using Engraver.Galil.Language;

namespace Engraver.Galil.Programs.Posting;

/// <summary>The two ways in which a job becomes a program for the controller (<see cref="DmcPost"/>), for the table of posts.</summary>
public sealed class GalilPost : IPost
{
    /// <summary>The subprograms of either way and some strokes need so many.</summary>
    private const int FewestLines = 100;

    private static PostOption Memory => new(
        "memory",
        "LINES",
        Wording.Get("GalilPost.Memory"),
        Text(DmcLimits.ProgramLines),
        Wording.Get("GalilPost.Lines", FewestLines, DmcLimits.ProgramLines),
        value => int.TryParse(value, NumberStyles.None, CultureInfo.InvariantCulture, out var lines) && lines is >= FewestLines and <= DmcLimits.ProgramLines);

    private readonly MotionStyle _style;

    private GalilPost(string name, MotionStyle style) => (Name, _style) = (name, style);

    public static GalilPost Sequences { get; } = new("galil", MotionStyle.Continuous);

    public static GalilPost Calls { get; } = new("galil-calls", MotionStyle.Calls);

    public string Name { get; }

    public string Summary => Wording.Get("Post." + Name);

    public string Ending => ".dmc";

    public PostGeometry Geometry => PostGeometry.Program;

    public MotionStyle? Motion => _style;

    public IReadOnlyList<PostOption> Options => [Memory];

    /// <exception cref="ArgumentException">The request has no program in this style.</exception>
    public PostText Write(PostRequest request)
    {
        ArgumentNullException.ThrowIfNull(request);
        if (request.Program is not { } program || program.Style != _style) throw new ArgumentException($"{Name} is written from a motion program in the style {_style}.", nameof(request));
        var options = new DmcPostOptions { MemoryLines = int.Parse(request.Value(Memory), CultureInfo.InvariantCulture) };
        var text = _style == MotionStyle.Calls ? DmcPost.Calls(program, options, request.SourceOf) : DmcPost.Sequences(program, options, request.SourceOf);
        return text with { SegmentLines = Posting.SegmentLines.Map(text.Text, _style) };
    }

    private static string Text(int lines) => lines.ToString(CultureInfo.InvariantCulture);
}
