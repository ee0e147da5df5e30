using System.Globalization;
using Engraver.Core;
using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Core.Operations;
using Engraver.Core.Posts;
using Engraver.Galil.Language;

namespace Engraver.Galil.Programs.Posting;

/// <summary>The two ways to write a job as a program for the controller (<see cref="DmcPost"/>), for the table of posts.</summary>
public sealed class GalilPost : IPost
{
    /// <summary>Number of lines needed by the subprograms of either way and a few strokes.</summary>
    private const int MinLines = 100;

    private static PostOption Memory => new(
        "memory",
        "LINES",
        Wording.Get("GalilPost.Memory"),
        NumberText.Whole(DmcLimits.ProgramLines),
        Wording.Get("GalilPost.MemoryValues", MinLines, DmcLimits.ProgramLines),
        value => int.TryParse(value, NumberStyles.None, CultureInfo.InvariantCulture, out var lines) && lines is >= MinLines and <= DmcLimits.ProgramLines);

    private static PostOption Unattended => new("unattended", "ANSWER", Wording.Get("GalilPost.Unattended"), "no", Wording.Get("GalilPost.YesOrNo"), value => value is "yes" or "no");

    private static PostOption Origin => new("origin", "PLACE", Wording.Get("GalilPost.Origin"), Here, Wording.Get("GalilPost.OriginValues"), value => value == Here || Place(value) is not null);

    private const string Here = "here";

    private readonly MotionStyle _style;

    private GalilPost(string name, MotionStyle style) => (Name, _style) = (name, style);

    public static GalilPost Sequences { get; } = new("galil", MotionStyle.Continuous);

    public static GalilPost Calls { get; } = new("galil-calls", MotionStyle.Calls);

    public string Name { get; }

    public string Summary => Wording.Get("Post." + Name);

    public string FileExtension => ".dmc";

    public PostGeometry Geometry => PostGeometry.Program;

    public MotionStyle? Motion => _style;

    public string? OperationsRefusal => null;

    public OperationSupport SupportOf(PostRequest request)
    {
        ArgumentNullException.ThrowIfNull(request);
        return ProgramSupport.On(Name, request.Machine);
    }

    public IReadOnlyList<PostOption> Options => [Memory, Unattended, Origin];

    /// <exception cref="ArgumentException">The request has no program in this style.</exception>
    public PostOutput Write(PostRequest request)
    {
        var program = ProgramOf(request);
        var options = new DmcPostOptions { MemoryLines = int.Parse(request.Value(Memory), CultureInfo.InvariantCulture), Unattended = request.Value(Unattended) == "yes" };
        if (Place(request.Value(Origin)) is { } place)
        {
            if (OriginOf(program, place) is not { } origin) return new PostOutput([], [MotionRules.OutsideCounts.At(default, NumberText.Exact(place[0]), NumberText.Exact(place[1]), NumberText.Exact(program.Profile.Scale.X.CountsPerMillimetre), NumberText.Exact(program.Profile.Scale.Y.CountsPerMillimetre))]);
            options = options with { Origin = origin };
        }

        var text = _style == MotionStyle.Calls ? DmcPost.Calls(program, options, request.SourceOf) : DmcPost.Sequences(program, options, request.SourceOf);
        return text with { SegmentLines = Posting.SegmentLines.Map(text.Chunks, _style) };
    }

    /// <summary>Without options the number of segments shows for nearly every stroke that it fits the memory, so that a million of them need not be
    /// written.</summary>
    /// <exception cref="ArgumentException">The request has no program in this style.</exception>
    public IReadOnlyList<Diagnostic> Findings(PostRequest request)
    {
        var program = ProgramOf(request);
        return request.Options.Count > 0 ? Write(request).Diagnostics : DmcPost.Findings(program, DmcPostOptions.Default, request.SourceOf);
    }

    private MotionProgram ProgramOf(PostRequest request)
    {
        ArgumentNullException.ThrowIfNull(request);
        return request.Program is { } program && program.Style == _style ? program : throw new ArgumentException($"{Name} is written from a motion program in the style {_style}.", nameof(request));
    }

    /// <summary>Two or three finite numbers separated by commas, mm; null for anything else.</summary>
    private static double[]? Place(string text)
    {
        var words = text.Split(',');
        var numbers = words.Select(word => double.TryParse(word, NumberStyles.AllowDecimalPoint | NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out var number) && double.IsFinite(number) ? number : double.NaN).ToArray();
        return words.Length is 2 or 3 && !numbers.Any(double.IsNaN) ? numbers : null;
    }

    /// <summary>The position in counts; null when part of the job is outside the controller's range of counts.</summary>
    private static PostOrigin? OriginOf(MotionProgram program, double[] place)
    {
        const double Room = int.MaxValue / 2;
        var scale = program.Profile.Scale;
        var (at, z) = (new Point2D(place[0], place[1]), place.Length == 3 ? scale.Z.Exact(place[2]) : 0.0);
        if (!scale.Counts(at) || Math.Abs(z) > Room) return null;
        var origin = scale.ToCounts(at);
        return new ControllerFrame(default, origin).IsInRange(MotionExtents.Of(program)) ? new PostOrigin(origin.X, origin.Y, place.Length == 3 ? (int)Math.Round(z) : null) : null;
    }
}
