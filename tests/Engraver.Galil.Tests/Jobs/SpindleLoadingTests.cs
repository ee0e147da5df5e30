using Engraver.Core.Machines;
using Engraver.Galil.Jobs;
using Engraver.Galil.Language;
using Engraver.Galil.Tests.Jobs.Holds;
using Engraver.TestKit;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>While a program of a job is loaded, no watchdog runs in the controller, so the spindle must not turn: a lost host could not switch it
/// off.</summary>
public class SpindleLoadingTests
{
    /// <summary>Room for the part as two programs, most of it for the subprograms.</summary>
    private const int Lines = 130;

    private static readonly JobOptions s_program = SimulatedBench.Job with { Strategy = JobMode.Program.Strategy() };

    private static readonly MotionProgram s_part = Rake();

    [Fact]
    public async Task The_spindle_stands_whenever_no_watchdog_runs_and_turns_in_every_program_of_the_job()
    {
        var (watched, turnsUnwatched, loads) = (false, 0, 0);
        await using var bench = new SimulatedBench(programLines: Lines);
        await using var session = await bench.OpenAsync(link => link.Sending = line =>
        {
            if (line.StartsWith("HX1", StringComparison.Ordinal)) watched = false;
            if (line.StartsWith("XQ #JOB", StringComparison.Ordinal)) (watched, loads) = (true, loads + 1);
            if (!watched && loads > 0 && bench.Controller.Status.Outputs != 0) turnsUnwatched++;
        });

        var result = await JobRunner.RunAsync(s_part, session, s_program, null, CancellationToken.None);

        Assert.Equal("Done: 12 segments.", result.Message);
        Assert.InRange(loads, 2, 9);
        Assert.Equal(0, turnsUnwatched);
        HeightBench.AssertCut(bench, s_part);
        HeightBench.AssertGentle(bench, s_part);
    }

    /// <summary>Both links are cut before each line that is sent from shortly before a program is loaded until the spindle turns.</summary>
    [Fact]
    public async Task Links_that_are_lost_while_a_program_is_loaded_or_has_just_begun_leave_no_spindle_turning()
    {
        var whole = await LinesAsync();
        var about = Enumerable.Range(0, whole.Count).Where(i => whole.Skip(Math.Max(0, i - 24)).Take(27).Any(line => line.StartsWith("DL\r#JOB", StringComparison.Ordinal))).ToList();
        Assert.InRange(about.Count, 30, 200);
        foreach (var at in about.Where((_, i) => TestExtent.IsFull || i % 2 == 0))
        {
            await using var bench = new SimulatedBench(programLines: Lines);
            var sent = 0;
            await using var session = await bench.OpenAsync(link => link.Sending = line =>
            {
                if (sent++ == at) bench.Controller.DropConnections();
            });

            var result = await JobRunner.RunAsync(s_part, session, s_program, null, CancellationToken.None);
            bench.ReleaseClock();
            bench.Controller.AdvanceUntil(status => status.IsIdle, TimeSpan.FromSeconds(30));

            Assert.True(result.Outcome == JobOutcome.LinkLost, $"line {at}, {whole[at]}: {result.Message}");
            Assert.True(bench.Controller.Status is { Outputs: 0, IsMoving: false }, $"line {at}, {whole[at]}: outputs {bench.Controller.Status.Outputs}");
        }
    }

    /// <summary>Level lines beside each other, in the work.</summary>
    private static MotionProgram Rake()
    {
        var strokes = Enumerable.Range(0, 12).Select(i => (From: new CountsPoint(2000, 1000 * (i + 1), -800), To: new CountsPoint(6000, 1000 * (i + 1), -800), Index: i));
        return new MotionProgram(HeightBench.Profile, default, [.. strokes.Select(line => new MotionStroke(line.Index, line.From, [new VectorSequence(line.From, 20000, [HeightBench.Line(line.From, line.To)])]))]);
    }

    private static async Task<List<string>> LinesAsync()
    {
        var lines = new List<string>();
        await using var bench = new SimulatedBench(programLines: Lines);
        await using var session = await bench.OpenAsync(link => link.Sending = lines.Add);
        var result = await JobRunner.RunAsync(s_part, session, s_program, null, CancellationToken.None);
        Assert.Equal(JobOutcome.Complete, result.Outcome);
        return lines;
    }
}
