using Engraver.Core.Machines;
using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Machines;

namespace Engraver.Workbench.Tests.Commands;

public class JobCommandTests
{
    [Fact]
    public async Task Post_table_and_plot_write_what_the_verbs_write()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("gasket.dxf"));
        await talk.TypeAsync("POST", "Galil", "a.dmc", "POST", "galil-calls", "b.dmc", "TABLE", "S", "Csv", "c.csv", "PLOT", "", "d.svg");

        foreach (var (written, golden) in new[] { ("a.dmc", "gasket.galil.dmc"), ("b.dmc", "gasket.galil-calls.dmc"), ("c.csv", "gasket.table.csv"), ("d.svg", "gasket.path.svg") })
            Assert.Equal(await File.ReadAllTextAsync(CommandTestSession.Sample(Path.Combine("expected", golden))), await File.ReadAllTextAsync(talk.PathOf(written)));
    }

    [Fact]
    public async Task An_edited_drawing_is_cut_as_edited()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("paper-001.dxf"), "MI", "ALL", "", "0,0", "1,0", "Y", "RO", "P", "", "10,20", "33", "SC", "P", "", "3,3", "0.5", "REVERSE", "P", "");

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCSIM"));
        Assert.Matches("^complete: ([0-9]+) of \\1 segments", talk.Said.Split('\n')[^1]);
        Assert.Contains("the whole drawing was cut", talk.Said, StringComparison.Ordinal);
        Assert.InRange(talk.Session.Machine.Runs.LastRun!.Judgement.MaxDeviationMm!.Value, 0.0, 0.0035);
    }

    [Fact]
    public async Task Connect_run_twice_and_disconnect()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("paper-001.dxf"), "CNCCONNECT", "sim:", "CNCSTATUS");
        Assert.Contains("SIMULATION: DMC2143", talk.Said, StringComparison.Ordinal);
        await talk.TypeAsync("CNCRUN", "Yes");
        await talk.TypeAsync("CNCRUN", "C", "Y");
        var run = talk.Session.Machine.Runs.LastRun!;

        Assert.Equal(0.0, run.Judgement.MissingLengthMm);
        Assert.Equal(new CountsPoint(0, 0), run.Result.FinalPosition); // Back at the drawing's start both times.
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCDISCONNECT"));
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCDISCONNECT"));
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCRUN"));
    }

    [Fact]
    public async Task Nothing_starts_without_a_typed_yes()
    {
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("paper-001.dxf"), "CNCCONNECT", "sim:", "CNCRUN");
        Assert.Equal("No", talk.Session.Prompt.Default);

        Assert.IsType<InputResult.Done>(await talk.TypeAsync(""));
        Assert.Null(talk.Session.Machine.Runs.LastRun);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCRUN", "Dryrun", "Yes"));
        Assert.Equal("none", talk.Session.Machine.Runs.LastRun!.Judgement.Source);
    }

    [Fact]
    public async Task While_a_job_runs_CNCSTOP_and_CNCSTATUS_are_heard_and_nothing_else()
    {
        await using var talk = new CommandTestSession();
        using var limit = new CancellationTokenSource(TimeSpan.FromSeconds(60));
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("paper-001.dxf"), "CNCCONNECT", SlowSimulator.Address, "CNCRUN");
        var moving = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        talk.Session.Machine.Changed += (_, _) => { if (talk.Session.Machine.Runs.Progress is not null) moving.TrySetResult(); };
        var job = talk.TypeAsync("Yes");
        await moving.Task.WaitAsync(limit.Token);

        Assert.True(talk.Session.IsBusy);
        Assert.IsType<InputResult.NotAccepted>(await talk.TypeAsync("ERASE"));
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("'CNCSTATUS"));
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCSTOP"));
        Assert.Equal(CommandFailure.Stopped, Assert.IsType<InputResult.Failed>(await job.WaitAsync(limit.Token)).Reason);
        Assert.False(talk.Session.Machine.IsRunning);
        Assert.Contains("RUNNING", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_job_is_held_overridden_and_resumed_by_commands_that_are_heard_beside_it()
    {
        await using var talk = new CommandTestSession();
        using var limit = new CancellationTokenSource(TimeSpan.FromSeconds(60));
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("paper-001.dxf"), "CNCCONNECT", SlowSimulator.Address);
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCHOLD"));
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCRESUME", "Whole")); // Without a held job it selects what START cuts.
        await talk.TypeAsync("CNCOVERRIDE", "50", "CNCRUN");
        var job = talk.TypeAsync("Yes");
        await UntilAsync(talk, () => talk.Session.Machine.Runs.Progress is not null, limit.Token);

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCHOLD"));
        await UntilAsync(talk, () => talk.Session.Machine.Status.State == MachineState.Held, limit.Token);
        Assert.Equal(0.5, talk.Session.Machine.Runs.Progress!.Value.FeedRatio);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCOVERRIDE 80"));
        Assert.IsType<InputResult.AwaitingInput>(await talk.TypeAsync("CNCOVERRIDE"));
        Assert.StartsWith("Enter feed override in percent", talk.Session.Prompt.Text, StringComparison.Ordinal);
        Assert.IsType<InputResult.NotAccepted>(await talk.TypeAsync("900"));
        Assert.IsType<InputResult.AwaitingInput>(await talk.TypeAsync("Rapid"));
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("30"));
        Assert.Equal((0.8, 0.3), (talk.Session.Machine.Status.FeedRatio, talk.Session.Machine.Status.RapidRatio));
        Assert.IsType<InputResult.AwaitingInput>(await talk.TypeAsync("CNCOVERRIDE"));
        await talk.Session.CancelAsync(); // ends the question, not the job
        Assert.True(talk.Session.IsBusy);

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCRESUME"));
        await UntilAsync(talk, () => talk.Session.Machine.Status.State == MachineState.Running, limit.Token);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCHOLD"));
        await UntilAsync(talk, () => talk.Session.Machine.Status.State == MachineState.Held, limit.Token);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCSTOP"));
        Assert.Equal(CommandFailure.Stopped, Assert.IsType<InputResult.Failed>(await job.WaitAsync(limit.Token)).Reason);
        Assert.Equal((2, false), (talk.Session.Machine.Runs.LastRun!.Result.Holds, talk.Session.Machine.IsRunning));
        Assert.IsType<InputResult.AwaitingInput>(await talk.TypeAsync("CNCRESUME"));
        Assert.Equal(talk.Session.Machine.Runs.LastRun.Journal, talk.Session.Prompt.Default);
    }

    [Fact]
    public async Task A_held_job_lets_CNCJOG_move_the_machine_and_comes_back_before_it_goes_on()
    {
        await using var talk = new CommandTestSession();
        using var limit = new CancellationTokenSource(TimeSpan.FromSeconds(60));
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("paper-001.dxf"), "CNCCONNECT", SlowSimulator.Address, "CNCRUN");
        var job = talk.TypeAsync("Yes");
        await UntilAsync(talk, () => talk.Session.Machine.Runs.Progress is not null, limit.Token);
        Assert.Equal(CommandFailure.Refused, Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCJOG 1,0")).Reason);
        Assert.Contains("Hold the job (CNCHOLD)", talk.Said, StringComparison.Ordinal);
        await talk.TypeAsync("CNCHOLD");
        await UntilAsync(talk, () => talk.Session.Machine.Status.State == MachineState.Held, limit.Token);
        var held = talk.Session.Machine.Status.MachinePosition!.Value;

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCJOG 2,-1"));
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCJOG Y+ 0.5"));

        var away = talk.Session.Machine.Status.MachinePosition!.Value;
        Assert.Equal((2.0, -0.5), (Math.Round(away.X - held.X, 2), Math.Round(away.Y - held.Y, 2)));
        Assert.Equal(MachineState.Held, talk.Session.Machine.Status.State);
        using var alive = new FrontEnd(talk.Session.Machine);
        Assert.IsType<InputResult.AwaitingInput>(await talk.TypeAsync("CNCJOG X+ Continuous"));
        await UntilAsync(talk, () => talk.Session.Machine.Status.MachinePosition!.Value.X > away.X + 1.0, limit.Token);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync(""));
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCOVERRIDE 200"));
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCRESUME"));
        Assert.IsType<InputResult.Done>(await job.WaitAsync(limit.Token));

        var run = talk.Session.Machine.Runs.LastRun!;
        Assert.Equal((JobOutcome.Complete, 1, 0.0), (run.Result.Outcome, run.Result.Holds, run.Judgement.MissingLengthMm));
        Assert.InRange(run.Judgement.MaxDeviationMm!.Value, 0.0, 0.0035);
    }

    private static async Task UntilAsync(CommandTestSession talk, Func<bool> condition, CancellationToken limit)
    {
        var met = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        void Look(object? sender, EventArgs e)
        {
            if (condition()) met.TrySetResult();
        }

        talk.Session.Machine.Changed += Look;
        Look(null, EventArgs.Empty);
        await met.Task.WaitAsync(limit);
        talk.Session.Machine.Changed -= Look;
    }

    [Fact]
    public async Task An_address_that_is_none_or_nobody_answers_at_is_said_so()
    {
        await using var talk = new CommandTestSession();
        using var listener = new System.Net.Sockets.TcpListener(System.Net.IPAddress.Loopback, 0);
        listener.Start();
        var port = ((System.Net.IPEndPoint)listener.LocalEndpoint).Port;
        listener.Stop();

        Assert.Equal(CommandFailure.Usage, Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCCONNECT", "somewhere")).Reason);
        Assert.Equal(CommandFailure.LinkLost, Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCCONNECT", FormattableString.Invariant($"tcp://127.0.0.1:{port}"))).Reason);
        Assert.Null(talk.Session.Machine.Connection.Description);
    }

    [Fact]
    public async Task Check_fails_on_a_drawing_with_errors_and_a_job_asks_first()
    {
        await using var talk = new CommandTestSession();
        await File.WriteAllTextAsync(talk.PathOf("cut.dxf"), "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n0\n20\n0\n11\n3\n21\n4\n0\nLINE\n8\n0\n10\n0\n");

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("OPEN", "cut.dxf"));
        Assert.Equal(CommandFailure.Drawing, Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CHECK")).Reason);
        Assert.Equal(CommandFailure.Drawing, Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCSIM", "")).Reason);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCSIM", "Yes"));
    }

    [Fact]
    public async Task A_machine_profile_is_taken_from_a_file_and_a_bad_one_is_named()
    {
        await using var talk = new CommandTestSession();
        await File.WriteAllTextAsync(talk.PathOf("good.json"), "{ \"feedMmPerMinute\": 300 }");
        await File.WriteAllTextAsync(talk.PathOf("bad.json"), "{\n\"feed\": 300 }");
        await talk.TypeAsync("CNCPROFILE", "good.json");

        Assert.Equal(300, talk.State.Settings.Machine.FeedMmPerMinute);
        Assert.Contains("bad.json(2)", Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCPROFILE", "bad.json")).Message, StringComparison.Ordinal);
    }
}
