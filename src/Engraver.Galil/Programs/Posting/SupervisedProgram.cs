using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Resident;
using static Engraver.Galil.Programs.Resident.ResidentProgram;
using static Engraver.Galil.Programs.Subprograms;

namespace Engraver.Galil.Programs.Posting;

/// <summary>A job as programs that cut independently while a host watches (the method of paper 001; galil-dmc.md F.1 method 2): counted, checked after every
/// motion, with the watchdog, #POSERR and #CMDERR.</summary>
/// <remarks> <c>seq</c> is incremented twice for each vector sequence. It is odd while the sequence runs, so that <c>_CSS</c> is known to belong to it, and
/// even between sequences. It is incremented again when the chunk is complete and the tool has settled. A motion that did not end at its target (a limit
/// switch, an ST of another host) ends in #STRAY: tool off, stop, <c>errcode</c> -1. Without this check the program would continue from the wrong position.
/// </remarks>
internal sealed class SupervisedProgram
{
    /// <summary>Value of the error code when a motion ended early; TC codes are positive.</summary>
    public const int EndedEarlyCode = -1;

    public const string Entry = "#JOB";

    private const string EndedEarlyLabel = "#STRAY";
    private const string CountSequence = $"{Variables.Sequence}={Variables.Sequence}+1";

    private readonly MachineProfile _profile;
    private readonly PostTemplate _form;

    /// <param name="program">Continuous or calls, as generated.</param>
    /// <param name="frame">Position of the job's frame by the controller's zero.</param>
    /// <param name="dryRun">The tool is never switched on.</param>
    public SupervisedProgram(MotionProgram program, ControllerFrame frame, bool dryRun)
    {
        _profile = program.Profile;
        var (toolOn, toolOff) = SequenceSyntax.ToolOf(_profile, dryRun, HasOwnPlunges(program), height => DmcFormat.Text($"{height}"));
        var spelling = new SequenceSyntax($"CSS;{CountSequence}", "JS#CUT", place => DmcFormat.Text($"x={place.X};y={place.Y};JS{Rapid}"), toolOn, toolOff, terms => dryRun ? [] : Ready(program.Profile, terms));
        _form = new PostTemplate((_, _) => Opening(_profile, frame), new SequenceWriter(_profile, frame, spelling).Stroke, Closing(_profile, HasOwnPlunges(program))) { MaxLines = SequenceWriter.MaxLines };
    }

    /// <summary>The smallest memory for which the job can be packed, lines.</summary>
    public int MinLines => ChunkPacker.MinLines(_form);

    /// <summary>Value of seq when the chunk is complete.</summary>
    public static int EndMark(ProgramChunk chunk) => (2 * chunk.Parts.Sum(part => part.Sequences.Count)) + 1;

    public PackedJob Pack(IEnumerable<MotionStroke> strokes, int memoryLines, Func<int, SourceRef>? sourceOf) =>
        ChunkPacker.Pack(strokes, _form, DmcPostOptions.Default with { MemoryLines = memoryLines }, sourceOf);

    /// <summary>True for a chunk of such a job on this machine: it contains these subprograms.</summary>
    public static bool IsChunk(string program, MachineProfile profile)
    {
        var lines = program.Split('\n', StringSplitOptions.TrimEntries | StringSplitOptions.RemoveEmptyEntries);
        return EndsWith(lines, Closing(profile, ownPlunges: false)) || (profile.Height is not null && EndsWith(lines, Closing(profile, ownPlunges: true)));
    }

    private static bool EndsWith(string[] lines, IReadOnlyList<string> closing) => lines.Length > closing.Count && lines.Skip(lines.Length - closing.Count).SequenceEqual(closing);

    private static IReadOnlyList<string> Opening(MachineProfile profile, ControllerFrame frame) =>
    [
        Entry,
        $"{CommandErrorProgram.ClearStatement};{Variables.Sequence}=0",
        WatchdogProgram.StartStatement,
        .. profile.Height is null ? [ToolOff(profile)] : (IReadOnlyList<string>)[],
        .. SetUpLines(profile),
        .. profile.Height is null ? [] : HeightOpening(profile, frame.HeightOf(0)),
    ];

    /// <summary>Assigns the heights by the controller's own zero, and raises the tool before the first rapid.</summary>
    private static IReadOnlyList<string> HeightOpening(MachineProfile profile, int zero) => [DmcFormat.Text($"{ClearanceHeight}={zero + profile.ClearanceCounts};zr={zero + profile.RetractCounts}"), "JS" + Up];

    /// <summary>The end of a rapid: during a hold by the host, no step that would switch the tool on is started.</summary>
    private static IReadOnlyList<string> GateLines { get; } =
        new ProgramLines().Line("#GATE").Line($"{Variables.AtGate}={Variables.Hold}").Line($"JP#GATE,{Variables.AtGate}<>0").Line("EN").Lines;

    private static IReadOnlyList<string> Closing(MachineProfile profile, bool ownPlunges) =>
    [
        CountSequence,
        "JP#HALT",
        .. new ProgramLines().Line("#CUT").Line("AMS").Line($"JP{EndedEarlyLabel},_SC{profile.Axes.X.Letter}<>101").Line(CountSequence).Line("EN").Lines,
        .. RapidLines(profile, $"JP{EndedEarlyLabel},(_RP{profile.Axes.X.Letter}<>x)|(_RP{profile.Axes.Y.Letter}<>y)").SkipLast(1),
        .. GateLines,
        .. profile.Axes.Z is { } z && profile.Height is not null ? [.. DownLines(profile, ownPlunges, $"JP{EndedEarlyLabel},_RP{z.Letter}<>z", string.Empty), .. UpLines(profile, string.Empty)] : (IReadOnlyList<string>)[],
        .. SequenceWriter.RoomLines($"JP{EndedEarlyLabel},_BGS=0"),
        .. new ProgramLines().Line(EndedEarlyLabel).Line(StopEverything(profile)).Line(DmcFormat.Text($"{Variables.ErrorCode}={EndedEarlyCode}")).Line("ZS").Line("JP#HALT").Lines,
        .. Guards(profile),
    ];
}
