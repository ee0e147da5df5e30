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

    private static readonly PostOption s_memory = new(
        "memory",
        "LINES",
        "Lines that the controller's program memory holds; a longer job comes in chunks.",
        Text(DmcLimits.ProgramLines),
        $"a whole number from {Text(FewestLines)} to {Text(DmcLimits.ProgramLines)}",
        value => int.TryParse(value, NumberStyles.None, CultureInfo.InvariantCulture, out var lines) && lines is >= FewestLines and <= DmcLimits.ProgramLines);

    private readonly MotionStyle _style;

    private GalilPost(string name, string summary, MotionStyle style) => (Name, Summary, _style) = (name, summary, style);

    public static GalilPost Sequences { get; } = new("galil", "continuous vector sequences", MotionStyle.Continuous);

    public static GalilPost Calls { get; } = new("galil-calls", "the paper's calls of #LINEAR and #CIRC", MotionStyle.Calls);

    public string Name { get; }

    public string Summary { get; }

    public string Ending => ".dmc";

    public MotionStyle? Motion => _style;

    public IReadOnlyList<PostOption> Options => [s_memory];

    /// <exception cref="ArgumentException">The request has no program in this style.</exception>
    public PostText Write(PostRequest request)
    {
        ArgumentNullException.ThrowIfNull(request);
        if (request.Program is not { } program || program.Style != _style) throw new ArgumentException($"{Name} is written from a motion program in the style {_style}.", nameof(request));
        var options = new DmcPostOptions { MemoryLines = int.Parse(request.Value(s_memory), CultureInfo.InvariantCulture) };
        var text = _style == MotionStyle.Calls ? DmcPost.Calls(program, options, request.SourceOf) : DmcPost.Sequences(program, options, request.SourceOf);
        return text with { SegmentLines = Posting.SegmentLines.Map(text.Text, _style) };
    }

    private static string Text(int lines) => lines.ToString(CultureInfo.InvariantCulture);
}
