using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Posts;
using Engraver.Galil.Language;
using static Engraver.Galil.Programs.Subprograms;

namespace Engraver.Galil.Programs.Posting;

/// <summary>Writes a motion program as self-contained controller programs, started with XQ #JOB.</summary>
/// <remarks>One or more chunks, each complete with its subprograms, to be downloaded and run (XQ #JOB) in order. With more than one, each starts with a comment
/// line "'CHUNK 2 OF 3". The machine's position at the start of the job is the drawing's start point, at any reading of the controller's position: the first
/// chunk stores this reading in ox and oy, rapids are relative to it, and later chunks still find it there, because a download does not change the
/// variables.</remarks>
public static class DmcPost
{
    private const string CountCall = "seq=seq+1";

    /// <summary>The method of the paper (section 5.2): variables are assigned and #LINEAR or #CIRC is called, in one line each; seq counts the calls, including
    /// rapids and tool changes.</summary>
    /// <param name="program">Generated with <see cref="MotionStyle.Calls"/>: every call ends at rest, so its arcs are computed from there.</param>
    /// <param name="options">The controller's memory.</param>
    /// <param name="sourceOf">Position of an entity in the drawing's file, for diagnostics.</param>
    public static PostOutput Calls(MotionProgram program, DmcPostOptions options, Func<int, SourceRef>? sourceOf = null)
    {
        if (program.Style != MotionStyle.Calls) throw new ArgumentException("The program was not generated for calls.", nameof(program));
        return Posted(program, CallsForm(program, options), options, sourceOf);
    }

    /// <summary>Continuous vector sequences (galil-dmc.md F.1 method 2): the machine stops only where the motion program does.</summary>
    public static PostOutput Sequences(MotionProgram program, DmcPostOptions options, Func<int, SourceRef>? sourceOf = null) => Posted(program, SequencesForm(program, options), options, sourceOf);

    /// <summary>The findings of the post in the style of the program. Only strokes that may be too long for the memory are written for this.</summary>
    internal static IReadOnlyList<Diagnostic> Findings(MotionProgram program, DmcPostOptions options, Func<int, SourceRef>? sourceOf)
    {
        var form = program.Style == MotionStyle.Calls ? CallsForm(program, options) : SequencesForm(program, options);
        return TooSmall(form, options) is { } refused ? [refused] : ChunkPacker.Findings(program.Strokes, form, options, sourceOf);
    }

    private static PostTemplate CallsForm(MotionProgram program, DmcPostOptions options)
    {
        var ownPlunges = HasOwnPlunges(program);
        return new PostTemplate((done, first) => CallsOpening(program, done, first, options), stroke => CallsStroke(program, stroke, FromStart(program), ownPlunges), CallsClosing(program, options)) { MaxLines = stroke => 3 + (stroke.Terms is { SetsOutputs: true } ? 1 : 0) + stroke.SegmentCount };
    }

    private static PostTemplate SequencesForm(MotionProgram program, DmcPostOptions options)
    {
        var axes = program.Profile.Axes;
        var (toolOn, toolOff) = SequenceSyntax.ToolOf(program.Profile, dryRun: false, HasOwnPlunges(program), height => DmcFormat.Text($"oz{height:+0;-0}"));
        var spelling = new SequenceSyntax(
            string.Empty, "AMS", place => $"{TargetLine(program.Profile, DmcFormat.Text($"ox{place.X:+0;-0}"), DmcFormat.Text($"oy{place.Y:+0;-0}"))};BG{axes.PlaneLetters};AM{axes.PlaneLetters}", toolOn, toolOff, terms => Ready(program.Profile, terms));
        var writer = new SequenceWriter(program.Profile, FromStart(program), spelling);
        return new PostTemplate((done, first) => Opening(program, done, first, string.Empty, options), writer.Stroke, SequencesClosing(program, options)) { MaxLines = SequenceWriter.MaxLines };
    }

    private static PostOutput Posted(MotionProgram program, PostTemplate form, DmcPostOptions options, Func<int, SourceRef>? sourceOf)
    {
        if (TooSmall(form, options) is { } refused) return new PostOutput([], [refused]);
        var packed = ChunkPacker.Pack(program.Strokes, form, options, sourceOf);
        IReadOnlyList<Diagnostic> parts = options.Unattended && packed.Chunks.Count > 1 ? [MotionRules.UnattendedInParts.At(default, DmcFormat.Text($"{packed.Chunks.Count}"), DmcFormat.Text($"{options.MemoryLines}"))] : [];
        return new PostOutput([.. packed.Chunks.Select(chunk => chunk.Text)], [.. packed.Diagnostics, .. parts]);
    }

    private static Diagnostic? TooSmall(PostTemplate form, DmcPostOptions options) => ChunkPacker.MinLines(form) is var needed && options.MemoryLines < needed
        ? MotionRules.MemoryTooSmall.At(default, DmcFormat.Text($"{needed}"), DmcFormat.Text($"{options.MemoryLines}"))
        : null;

    /// <summary>Positions relative to the position of the machine at the start of the job.</summary>
    private static ControllerFrame FromStart(MotionProgram program) => new(program.Start, default);

    /// <param name="first">Terms of the first stroke of this part.</param>
    /// <param name="variables">Their initial values; #UP counts as well, so they are set both before and after it.</param>
    private static IReadOnlyList<string> Opening(MotionProgram program, int done, StrokeTerms? first, string variables, DmcPostOptions options)
    {
        var types = MotorTypeTest.Lines(program.Profile);
        var lines = new ProgramLines().Line("#JOB").Line(types.Count > 0 ? ToolOff(program.Profile) : string.Empty);
        foreach (var line in types) lines.Line(line);
        lines.Line(types.Count > 0 ? string.Empty : ToolOff(program.Profile), "SH" + program.Profile.Axes.Letters, done == 0 ? TakeOrigin(program, options) : string.Empty);
        foreach (var line in SetUpLines(program.Profile)) lines.Line(line);
        if (program.Profile.Height is not null) lines.Line(variables).Line(DmcFormat.Text($"{ClearanceHeight}=oz{program.Profile.ClearanceCounts:+0;-0};zr=oz{program.Profile.RetractCounts:+0;-0}"), "JS" + Up);
        if (program.Profile.Spindle is { } spindle) lines.Line([.. SpindleOn(spindle, first), spindle.SpinUpSeconds > 0.0 ? DmcFormat.Text($"WT {DmcProfile.EvenMilliseconds(spindle.SpinUpSeconds)}") : string.Empty]);
        lines.Line([.. PowerZero(program.Profile)]);
        return lines.Line(variables).Line(options.Unattended ? UnattendedProgram.Start : string.Empty).Lines;
    }

    /// <summary>The drawing's start point by the controller's own zero: the present position of the machine, or a position derived from the given drawing
    /// zero.</summary>
    private static string TakeOrigin(MotionProgram program, DmcPostOptions options) => string.Join(';', "xyz".Zip(program.Profile.Axes.All, (name, axis) => (name, options.Origin) switch
    {
        ('x', { } origin) => DmcFormat.Text($"ox={origin.X + program.Start.X}"),
        ('y', { } origin) => DmcFormat.Text($"oy={origin.Y + program.Start.Y}"),
        ('z', { Z: { } height }) => DmcFormat.Text($"oz={height}"),
        _ => $"o{name}=_RP{axis.Letter}",
    }));

    private static IReadOnlyList<string> CallsOpening(MotionProgram program, int done, StrokeTerms? first, DmcPostOptions options) => Opening(program, done, first, DmcFormat.Text($"{UsualSpeeds(program.Profile)};seq={done}"), options);

    private static IReadOnlyList<string> CallsStroke(MotionProgram program, MotionStroke stroke, ControllerFrame frame, bool ownPlunges)
    {
        var (x, y, z) = frame.Of(stroke.Start);
        var isHeld = program.Profile.Height is not null;
        var lines = new ProgramLines().Line(Ready(program.Profile, stroke.Terms)).Line(DmcFormat.Text($"x={x}"), DmcFormat.Text($"y={y}"), $"JS{Rapid}")
            .Line([.. isHeld ? (string[])[DmcFormat.Text($"z=oz{z:+0;-0}"), PlungeAssignment(program.Profile, stroke.Terms, ownPlunges), "JS" + Down] : ["JS#TOOLON"], Wait(stroke.Terms?.PierceSeconds ?? 0.0)]);
        foreach (var sequence in stroke.Sequences)
        {
            foreach (var segment in sequence.Segments) lines.Line(Call(segment, sequence, program.Profile));
        }

        return lines.Line(Wait(stroke.Terms?.DwellSeconds ?? 0.0), isHeld ? "JS" + Up : "JS#TOOLOFF").Lines;
    }

    /// <summary>Speed and acceleration that most calls have; every call leaves them.</summary>
    private static string UsualSpeeds(MachineProfile profile) => DmcFormat.Text($"f={profile.VectorSpeed()};va={profile.AccelerationCounts}");

    private static string Call(in VectorSegment segment, VectorSequence sequence, MachineProfile profile)
    {
        var (x, y) = ((long)segment.End.X - sequence.Start.X, (long)segment.End.Y - sequence.Start.Y);
        var (target, label) = sequence.ChangesHeight ? (DmcFormat.Text($"x={x};y={y};z={(long)segment.End.Z - sequence.Start.Z}"), Slope)
            : segment.Kind == VectorSegmentKind.Line ? (DmcFormat.Text($"x={x};y={y}"), Linear)
            : (DmcFormat.Text($"r={segment.Radius};th={DmcFormat.Number(segment.ThetaDegrees)};da={DmcFormat.Number(segment.DeltaDegrees)}"), Circular);
        var (speed, acceleration) = (sequence.SpeedOf(segment), sequence.AccelerationOn(profile));
        var (f, va) = (speed == profile.VectorSpeed() ? string.Empty : DmcFormat.Text($"f={speed}"), acceleration == profile.AccelerationCounts ? string.Empty : DmcFormat.Text($"va={acceleration}"));
        return Statements(target, f, va, "JS" + label);
    }

    private static IReadOnlyList<string> CallsClosing(MotionProgram program, DmcPostOptions options)
    {
        var profile = program.Profile;
        return
        [
            .. End(program, options),
            .. LinearLines(profile, $"{UsualSpeeds(profile)};{CountCall}"),
            .. CircularLines(profile, $"{UsualSpeeds(profile)};{CountCall}"),
            .. RapidLines(profile, TargetLine(profile, "ox+x", "oy+y"), CountCall),
            .. profile.Height is null ? ToolLines(profile) : [.. SlopeLines(profile, $"{UsualSpeeds(profile)};{CountCall}"), .. DownLines(profile, HasOwnPlunges(program), string.Empty, CountCall), .. UpLines(profile, CountCall)],
            .. MotorTypeTest.Ends(profile),
            .. CommandErrorEndsTheJob(program, options),
            .. options.Unattended ? UnattendedProgram.Lines(profile, program.LongestWait) : [],
        ];
    }

    private static IReadOnlyList<string> ToolLines(MachineProfile profile) =>
    [
        .. new ProgramLines().Line("#TOOLON").Line(ToolOn(profile), Settle(profile)).Line(CountCall).Line("EN").Lines,
        .. new ProgramLines().Line("#TOOLOFF").Line(ToolOff(profile), Settle(profile, on: false)).Line(CountCall).Line("EN").Lines,
    ];

    private static IReadOnlyList<string> SequencesClosing(MotionProgram program, DmcPostOptions options) =>
    [
        .. End(program, options),
        .. program.Profile.Height is null ? [] : (IReadOnlyList<string>)[.. DownLines(program.Profile, HasOwnPlunges(program), string.Empty, string.Empty), .. UpLines(program.Profile, string.Empty)],
        .. SequenceWriter.RoomLines(string.Empty),
        .. MotorTypeTest.Ends(program.Profile),
        .. CommandErrorEndsTheJob(program, options),
        .. options.Unattended ? UnattendedProgram.Lines(program.Profile, program.LongestWait) : [],
    ];

    private static IReadOnlyList<string> End(MotionProgram program, DmcPostOptions options) => new ProgramLines().Line(options.Unattended ? UnattendedProgram.End : string.Empty).Line(ToolOff(program.Profile)).Line(RestOff(program.Profile)).Line("MG \"DONE\"").Line("EN").Lines;

    /// <summary>Without HX0 the controller would continue after the refused command, from a position that the program does not expect (galil-dmc.md
    /// C.3).</summary>
    private static IReadOnlyList<string> CommandErrorEndsTheJob(MotionProgram program, DmcPostOptions options) =>
        new ProgramLines().Line(CommandError).Line(StopEverything(program.Profile)).Line(program.Profile.Height is null ? string.Empty : RestOff(program.Profile)).Line("MG \"CMDERR\",_ED,_TC").Line(options.Unattended ? UnattendedProgram.End : string.Empty).Line("HX0").Line("EN").Lines;
}

/// <summary>The parts of a program in one way of posting; packing them into chunks is the same for all.</summary>
/// <param name="Opening">From the label #JOB to before the first stroke; the argument is the number of stroke lines that earlier chunks have run.</param>
/// <param name="Stroke">Rapid, tool on, cut, tool off.</param>
/// <param name="Closing">End of the job and every subprogram.</param>
internal sealed record PostTemplate(
    Func<int, StrokeTerms?, IReadOnlyList<string>> Opening, Func<MotionStroke, IReadOnlyList<string>> Stroke, IReadOnlyList<string> Closing)
{
    /// <summary>Upper bound of the number of lines of a stroke, determined without writing it.</summary>
    public required Func<MotionStroke, int> MaxLines { get; init; }
}
