using System.Globalization;
using System.Text.RegularExpressions;
using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.Links;
using Engraver.Simulator;
using Engraver.TestKit;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Machines;

/// <summary>One corrupted byte on the link: the job ends, and is never reported as complete with a wrong cut.</summary>
/// <remarks>ENGRAVER_HARM_CASES=1000 runs as many seeds; ENGRAVER_HARM_FIRST=N starts at another seed.</remarks>
public sealed class CorruptedByteTests : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-test-");

    public void Dispose() => _folder.Delete(recursive: true);

    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task A_wire_that_harms_nothing_carries_the_job_to_its_end(JobMode mode)
    {
        var run = await RunAsync(mode, new CorruptingWire(-1, 0));

        Assert.Equal(("complete", true), (run.Outcome, run.IsCutRight));
    }

    /// <summary>Regressions found with a proxy: a line ten times as long, a turn cut short, a speed, a tool that is not the tool.</summary>
    [Theory]
    [InlineData(JobMode.Stream, "LI ", 3)]
    [InlineData(JobMode.Stream, "VP ", 1)]
    [InlineData(JobMode.Stream, "CR ", 1)]
    [InlineData(JobMode.Stream, "SB ", 1)]
    [InlineData(JobMode.Stream, "CB ", 2)]
    [InlineData(JobMode.Calls, "x=", 3)]
    [InlineData(JobMode.Calls, "r=", 1)]
    public async Task One_digit_more_is_never_called_complete_when_the_part_is_wrong(JobMode mode, string command, int which)
    {
        var wire = new DigitWire(command, which);
        var run = await RunAsync(mode, wire);

        Assert.True(wire.Corrupted is not null, $"no line begins with {command}");
        Assert.False(run is { Outcome: "complete", IsCutRight: false }, run.ToString());
    }

    /// <summary>One vertex among segments shorter than the distance between two polls: no poll detects it, and the path length hardly changes.</summary>
    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task One_vertex_moved_by_a_few_counts_is_never_called_complete_when_the_part_is_wrong(JobMode mode)
    {
        var wrong = new List<string>();
        foreach (var (counts, (x, y), _) in TestExtent.InTurn([3, 5, 8, 12, 20, 40], [(1, 0), (0, 1), (-1, 0)], [0]))
        {
            var wire = new VertexWire(mode == JobMode.Program ? 3 : 23 + counts, x * counts, y * counts);
            var run = await RunAsync(mode, wire, ShortChords());

            Assert.True(wire.Corrupted is not null, "no vertex was sent");
            if (run is { Outcome: "complete", IsCutRight: false }) wrong.Add(Text($"'{wire.Corrupted?.Was}' -> '{wire.Corrupted?.Became}': {run}"));
        }

        Assert.True(wrong.Count == 0, string.Join('\n', wrong));
    }

    /// <summary>The same with an arc in the sequence. Over a network its vertices are sent as positions (VP) and not echoed: only the polls, the end and the
    /// length of the path can reveal it. The length may differ by 2 counts and half a count a segment, here 52 (galil-dmc.md B.1 does not define how it is
    /// computed). A vertex between two segments of 60 counts must be moved by 62 to add so much.</summary>
    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    public async Task One_vertex_moved_in_a_sequence_with_an_arc_is_found_where_it_is_farther_off_than_the_length_of_the_path_can_hide(JobMode mode)
    {
        const double Segments = 101.0;
        const double Chord = 60.0;
        var longest = Chord + ((2.0 + (0.5 * Segments)) / 2.0);
        var hidden = Math.Sqrt((longest * longest) - (Chord * Chord));
        var wrong = new List<string>();
        foreach (var (counts, (x, y), _) in TestExtent.InTurn([5, 20, 40, 60, 64, 70, 80, 100, 160, 400, 3000], [(1, 0), (0, 1), (-1, 0), (0, -1)], [0]))
        {
            var wire = new VertexWire(23 + (counts % 50), x * counts, y * counts);
            var run = await RunAsync(mode, wire, ShortChords(withArc: true));

            Assert.True(wire.Corrupted is not null, "no vertex was sent");
            if (run.Outcome == "complete" && !(run.Record.MaxDeviationMm <= hidden / 1000.0)) wrong.Add(Text($"{counts}: '{wire.Corrupted?.Was}' -> '{wire.Corrupted?.Became}': {run}"));
        }

        Assert.True(wrong.Count == 0, string.Join('\n', wrong));
    }

    /// <summary>Each command that switches the tool off arrives as one that switches it on, also those of the stop before and after the job.</summary>
    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task A_tool_that_a_damaged_command_leaves_on_is_told_and_off_in_the_end(JobMode mode)
    {
        var wrong = new List<string>();
        var which = 1;
        for (var isHarmed = true; isHarmed; which++)
        {
            var wire = new SwitchWire(which);
            var run = await RunAsync(mode, wire);
            isHarmed = wire.Corrupted is not null;
            if (run.IsToolOn || run is { Outcome: "complete", IsCutRight: false }) wrong.Add(Text($"{which} '{wire.Corrupted?.Was}': tool on {run.IsToolOn} {run}"));
        }

        Assert.True(wrong.Count == 0, string.Join('\n', wrong));
        Assert.InRange(which, 5, 100);
    }

    [Fact]
    public async Task No_harmed_byte_ends_as_complete_with_another_part_and_none_hangs()
    {
        var lines = new Dictionary<JobMode, int>();
        foreach (var mode in Enum.GetValues<JobMode>())
        {
            var wire = new CorruptingWire(-1, 0);
            await RunAsync(mode, wire);
            lines[mode] = wire.Harmable;
        }

        var (first, cases) = (TestExtent.Number("ENGRAVER_HARM_FIRST", 1), TestExtent.Cases(perCommit: 60, full: 1_000, "ENGRAVER_HARM_CASES"));
        var wrong = new List<string>();
        var outcomes = new SortedDictionary<string, int>(StringComparer.Ordinal);
        for (var seed = first; seed < first + cases; seed++)
        {
            var mode = (JobMode)(seed % 3);
            var wire = new CorruptingWire(new Random(seed).Next(lines[mode]), seed);
            var run = await RunAsync(mode, wire);
            outcomes[run.Outcome] = outcomes.GetValueOrDefault(run.Outcome) + 1;
            if (wire.IsHung || run is { Outcome: "complete", IsCutRight: false }) wrong.Add(Text($"seed {seed} {mode} '{wire.Corrupted?.Was}' -> '{wire.Corrupted?.Became}': {run} hung {wire.IsHung}"));
        }

        Assert.True(wrong.Count == 0, Text($"{wrong.Count} of {cases}:\n") + string.Join('\n', wrong));
        Assert.True(cases < 20 || outcomes.Count >= 3, string.Join(' ', outcomes)); // Corruption without effect would prove nothing.
    }

    private async Task<CorruptedRun> RunAsync(JobMode mode, CorruptingWire wire, byte[]? part = null)
    {
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity, Time = new ManualTimeProvider() });
        await using var connection = MachineConnection.FromLink("memory", _ => Task.FromResult<IControllerLink>(new CorruptingLink(new StreamLink(controller.OpenConnection(), "memory"), wire)), () => MachineClock.FromSimulator(controller.JoinClock()));
        var job = Job(mode, part ?? Part(), fitsArcs: part is null);
        var options = new MachineRunOptions(new TcpAddress("memory", 1), mode.Strategy()) { JournalPath = Path.Combine(_folder.FullName, "run.jsonl") };
        try
        {
            var report = await MachineRun.RunAsync(job, job.Motion.Program!, connection, options, TimeProvider.System, null, CancellationToken.None);
            return new CorruptedRun(OutcomeText.Token(report.Result.Outcome), report.Result.Message, RecordJudgement.Of(job, controller.Record.Snapshot(), 0, 0), RunJudge.Tolerances(job).Deviation) { IsToolOn = (controller.Status.Outputs & 1) != 0 };
        }
        catch (Engraver.Core.Machines.ControllerException unconnected)
        {
            return new CorruptedRun("unconnected", unconnected.Message, RunJudgement.Unknown, 0.0);
        }
    }

    private PreparedJob Job(JobMode mode, byte[] part, bool fitsArcs)
    {
        var path = Path.Combine(_folder.FullName, "part.dxf");
        File.WriteAllBytes(path, part);
        return JobPreparation.Prepare(DrawingFile.Open(path, new DrawingSettings(), CancellationToken.None), new DrawingSettings { CornerToleranceMm = 0.0, FitArcs = fitsArcs }, mode.Strategy().Style);
    }

    /// <summary>A round-ended plate with a hole, a slanting line on the negative side, and a bow of short chords: 70 mm in all.</summary>
    private static byte[] Part()
    {
        var part = new List<(int Code, object Value)>();
        void Line(double x1, double y1, double x2, double y2) => part.AddRange([(0, "LINE"), (8, "0"), (10, x1), (20, y1), (11, x2), (21, y2)]);
        Line(5, 5, 17, 5);
        Line(17, 5, 17, 12);
        part.AddRange([(0, "ARC"), (8, "0"), (10, 11.0), (20, 12.0), (40, 6.0), (50, 0.0), (51, 180.0)]);
        Line(5, 12, 5, 5);
        part.AddRange([(0, "CIRCLE"), (8, "0"), (10, 11.0), (20, 9.0), (40, 1.5)]);
        Line(-2, -3, -9, -6);
        for (var i = 0; i < 30; i++) Line(20 + (6 * Math.Cos(i * 0.08)), 6 * Math.Sin(i * 0.08), 20 + (6 * Math.Cos((i + 1) * 0.08)), 6 * Math.Sin((i + 1) * 0.08));
        return DxfText.WithEntities([.. part]).ToAscii();
    }

    /// <summary>Chords of 0.06 mm, 3 ms each at the profile's speed, on a bow that turns by a tenth of a degree from one to the next.</summary>
    private static byte[] ShortChords(bool withArc = false)
    {
        const double Radius = 30.0;
        const double Turn = 0.002;
        var part = new List<(int Code, object Value)>();
        (double X, double Y) At(int i) => (Radius * Math.Sin(i * Turn), Radius * Math.Cos(i * Turn));
        for (var i = 0; i < 100; i++) part.AddRange([(0, "LINE"), (8, "0"), (10, At(i).X), (20, At(i).Y), (11, At(i + 1).X), (21, At(i + 1).Y)]);
        if (withArc) part.AddRange([(0, "ARC"), (8, "0"), (10, At(100).X * 0.9), (20, At(100).Y * 0.9), (40, 3.0), (50, 0.0), (51, 90.0 - (100 * Turn * 180.0 / Math.PI))]); // It continues in the same direction.
        return DxfText.WithEntities([.. part]).ToAscii();
    }

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);

    /// <summary>Reported result of a run, and the actual motion.</summary>
    private sealed record CorruptedRun(string Outcome, string Sentence, RunJudgement Record, double Tolerance)
    {
        /// <summary>After the host has disconnected.</summary>
        public bool IsToolOn { get; init; }

        public bool IsCutRight => Record is { MaxDeviationMm: { } deviation, MissingLengthMm: { } missing } && deviation <= Tolerance && missing <= Tolerance;
    }

    /// <summary>Inserts a digit after the first digit of one such command.</summary>
    private sealed class DigitWire(string command, int which) : CorruptingWire(-1, 0)
    {
        private int _seen;

        protected override string? Corrupt(string line)
        {
            if (!line.StartsWith(command, StringComparison.Ordinal) || ++_seen != which) return null;
            var digit = line.IndexOfAny([.. "0123456789"]) + 1;
            return line.Insert(digit, "0");
        }
    }

    /// <summary>Changes one command that switches the tool off to one that switches it on.</summary>
    private sealed class SwitchWire(int which) : CorruptingWire(-1, 0)
    {
        private int _seen;

        protected override string? Corrupt(string line) => line.StartsWith("CB 1", StringComparison.Ordinal) && ++_seen == which ? "SB" + line[2..] : null;
    }

    /// <summary>Moves one vertex of a line by whole counts.</summary>
    private sealed class VertexWire(int which, int x, int y) : CorruptingWire(-1, 0)
    {
        private int _seen;

        protected override string? Corrupt(string line)
        {
            var vertex = Regex.Match(line, @"^(VP |LI |x=)(-?\d+)(,|;y=)(-?\d+)", RegexOptions.CultureInvariant);
            if (!vertex.Success || ++_seen != which) return null;
            int Number(int group, int more) => int.Parse(vertex.Groups[group].Value, CultureInfo.InvariantCulture) + more;
            return Text($"{vertex.Groups[1]}{Number(2, x)}{vertex.Groups[3]}{Number(4, y)}{line[vertex.Length..]}");
        }
    }
}
