using Engraver.Core.Machines;
using Engraver.Galil.Jobs;
using Engraver.Galil.Language;
using Engraver.Galil.Protocol;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Tests.Jobs;

public class ControllerRestoredTests
{
    private const string OwnersProgram = "#OWNER\nMG \"mine\"\nEN";

    public static TheoryData<JobMode, string> Ends => new()
    {
        { JobMode.Stream, "complete" }, { JobMode.Calls, "complete" }, { JobMode.Stream, "stopped" },
        { JobMode.Calls, "stopped" }, { JobMode.Stream, "refused" }, { JobMode.Calls, "refused" },
        { JobMode.Program, "complete" }, { JobMode.Program, "stopped" }, { JobMode.Program, "refused" },
    };

    [Theory]
    [MemberData(nameof(Ends))]
    public async Task However_a_job_ends_the_controller_is_as_it_was_found(JobMode mode, string end)
    {
        await using var bench = new SimulatedBench();
        await bench.DownloadAsync(OwnersProgram);
        await bench.SendAsync(
            "VSS=6000", "VAS=51200", "VDS=61440", "VR 0.25", "SPA=1234", "SPB=4320", "ACA=102400", "DCB=204800", "SPC=800", "CW 2", "VF 8.2", "SHAC", "MOBD");
        if (end == "refused") bench.Controller.SetLimitSwitch(1, forward: true, active: true);
        var before = await bench.FingerprintAsync();
        using var stop = new CancellationTokenSource();
        var press = new CancelWhen(progress => end == "stopped" && progress.X > 9000, stop.Cancel);

        var result = await bench.RunAsync(MotionPrograms.Paper, SimulatedBench.Job with { Strategy = mode.Strategy() }, press, stop.Token);

        Assert.Equal(end, result.Outcome.ToString().ToLowerInvariant());
        Assert.Empty(result.NotRestored);
        Assert.Equal(before, await bench.FingerprintAsync());
    }

    /// <summary>DL beside a running thread is refused, and the following lines are executed as commands.</summary>
    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Program)]
    public async Task A_watchdog_that_did_not_hear_its_halt_is_halted_before_the_memory_is_given_back(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        await bench.DownloadAsync(OwnersProgram);
        var before = await bench.FingerprintAsync();
        var halts = 0;
        await using (var session = await bench.OpenAsync(opened: link => link.Corrupt = line => line == "HX1\r" && ++halts <= 2 ? "HX6\r" : line))
        {
            var result = await JobRunner.RunAsync(MotionPrograms.Paper, session, SimulatedBench.Job with { Strategy = mode.Strategy() }, null, CancellationToken.None);

            Assert.Equal(JobOutcome.Complete, result.Outcome);
            Assert.Empty(result.NotRestored);
        }

        Assert.True(halts > 2);

        Assert.Equal(before, await bench.FingerprintAsync());
    }

    [Fact]
    public async Task Beside_a_thread_of_somebody_else_the_memory_is_left_alone()
    {
        const string Loop = "#LOOP\nWT 50\nJP #LOOP";
        await using var bench = new SimulatedBench();
        await bench.DownloadAsync(Loop);
        await bench.SendAsync("XQ #LOOP,5");
        await using var session = await bench.OpenAsync();

        var refused = await new ControllerProgramMemory(session).SwapAsync("BGA", CancellationToken.None);

        Assert.Equal((TcCode.DownloadWhileProgramRunning, "thread 5 is running; halt it with HX5"), (refused?.Code, refused?.Text));
        Assert.Contains("WT 50", Assert.IsType<Accepted>(await session.Commands.UploadAsync(CancellationToken.None)).Data, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Run_after_run_no_setting_drifts_by_the_last_bit()
    {
        await using var bench = new SimulatedBench();
        await bench.SendAsync("VR 0.3", "VF 7.1", "CAT", "VSS=6002");
        var before = await bench.FingerprintAsync();

        for (var run = 0; run < 3; run++) Assert.Empty((await bench.RunAsync(MotionPrograms.Paper, SimulatedBench.Job)).NotRestored);

        Assert.Equal(before, await bench.FingerprintAsync());
    }

    [Theory]
    [InlineData("VF 8.2", JobMode.Stream, "complete")]
    [InlineData("VF 10.0", JobMode.Calls, "complete")]
    [InlineData("VF -8.4", JobMode.Stream, "complete")]
    [InlineData("VF 6.3", JobMode.Program, "stopped")]
    [InlineData("VF 4.0", JobMode.Stream, "complete")]
    [InlineData("VF 2.0", JobMode.Program, "complete")]
    [InlineData("VF 7.1", JobMode.Stream, "serial")]
    [InlineData("VF -4.2", JobMode.Calls, "serial")]
    public async Task The_number_format_of_the_owner_is_the_same_after_a_run_and_hides_no_setting(string format, JobMode mode, string way)
    {
        await using var bench = new SimulatedBench();
        await bench.SendAsync("VAS=1024000", "SPA=123456", format);
        using var stop = new CancellationTokenSource();
        var press = new CancelWhen(progress => way == "stopped" && progress.X > 9000, stop.Cancel);

        var result = way == "serial"
            ? await bench.RunSerialAsync(19200, MotionPrograms.Paper, mode)
            : await bench.RunAsync(MotionPrograms.Paper, SimulatedBench.Job with { Strategy = mode.Strategy() }, press, stop.Token);

        Assert.Equal(way == "stopped" ? JobOutcome.Stopped : JobOutcome.Complete, result.Outcome);
        Assert.Empty(result.NotRestored);
        Assert.Equal(format[3..], await bench.NumberFormatAsync());
        Assert.Equal(["1024000", "123456"], [await bench.WholeAsync("_VAS"), await bench.WholeAsync("_SPA")]);
    }

    [Fact]
    public async Task An_empty_program_memory_is_empty_again()
    {
        await using var bench = new SimulatedBench();

        await bench.RunAsync(MotionPrograms.Paper, SimulatedBench.Job);

        Assert.EndsWith(new Accepted("").ToString(), await bench.FingerprintAsync(), StringComparison.Ordinal);
    }

    [Fact]
    public async Task The_found_program_is_kept_beside_the_journal()
    {
        await using var bench = new SimulatedBench();
        await bench.DownloadAsync(OwnersProgram);
        var folder = Directory.CreateTempSubdirectory();
        var journal = Path.Combine(folder.FullName, "job.jsonl");

        await bench.RunAsync(MotionPrograms.Paper, SimulatedBench.Job with { JournalPath = journal });

        Assert.Equal(OwnersProgram + "\n", await File.ReadAllTextAsync(journal + ".program.dmc"));
        folder.Delete(recursive: true);
    }

    [Fact]
    public async Task While_a_thread_of_somebody_else_runs_nothing_is_touched()
    {
        await using var bench = new SimulatedBench();
        await bench.DownloadAsync("#OWNER\n#LOOP\nWT 100\nJP#LOOP\nEN");
        await bench.SendAsync("XQ #OWNER,3");
        var before = await bench.FingerprintAsync();

        var result = await bench.RunAsync(MotionPrograms.Paper, SimulatedBench.Job);

        Assert.Equal((JobOutcome.Refused, 0), (result.Outcome, result.SegmentsSent));
        Assert.Contains("Thread 3", result.Message, StringComparison.Ordinal);
        Assert.Equal(before, await bench.FingerprintAsync());
    }

    [Fact]
    public async Task While_an_axis_moves_no_job_starts()
    {
        await using var bench = new SimulatedBench();
        await bench.SendAsync("SHC", "JGC=2000", "BGC");

        var result = await bench.RunAsync(MotionPrograms.Paper, SimulatedBench.Job);

        Assert.Equal(JobOutcome.Refused, result.Outcome);
        Assert.Contains("Axis C is moving", result.Message, StringComparison.Ordinal);
    }
}
