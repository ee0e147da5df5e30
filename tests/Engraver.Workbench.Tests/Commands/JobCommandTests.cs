using Engraver.Core.Machines;
using Engraver.TestKit;
using Engraver.Workbench.Commands;

namespace Engraver.Workbench.Tests.Commands;

public class JobCommandTests
{
    [Fact]
    public async Task Post_table_and_plot_write_what_the_verbs_write()
    {
        await using var talk = new CommandTalk();
        await talk.TypeAsync("OPEN", CommandTalk.Sample("gasket.dxf"));
        await talk.TypeAsync("POST", "Galil", "a.dmc", "POST", "galil-calls", "b.dmc", "TABLE", "S", "Csv", "c.csv", "PLOT", "", "d.svg");

        foreach (var (written, golden) in new[] { ("a.dmc", "gasket.galil.dmc"), ("b.dmc", "gasket.galil-calls.dmc"), ("c.csv", "gasket.table.csv"), ("d.svg", "gasket.path.svg") })
            Assert.Equal(await File.ReadAllTextAsync(CommandTalk.Sample(Path.Combine("expected", golden))), await File.ReadAllTextAsync(talk.PathOf(written)));
    }

    [Fact]
    public async Task An_edited_drawing_is_cut_as_edited()
    {
        await using var talk = new CommandTalk();
        await talk.TypeAsync("OPEN", CommandTalk.Sample("paper-001.dxf"), "MI", "ALL", "", "0,0", "1,0", "Y", "RO", "P", "", "10,20", "33", "SC", "P", "", "3,3", "0.5", "REVERSE", "P", "");

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCSIM"));
        Assert.Matches("^complete: 4 of 4 segments", talk.Said.Split('\n')[^1]);
        Assert.Contains("nothing of it is missing", talk.Said, StringComparison.Ordinal);
        Assert.InRange(talk.Session.Machine.LastRun!.Judgement.MaxDeviationMm!.Value, 0.0, 0.0035);
    }

    [Fact]
    public async Task Connect_run_twice_and_disconnect()
    {
        await using var talk = new CommandTalk();
        await talk.TypeAsync("OPEN", CommandTalk.Sample("paper-001.dxf"), "CNCCONNECT", "sim:", "CNCSTATUS");
        Assert.Contains("SIMULATION: DMC2143", talk.Said, StringComparison.Ordinal);
        await talk.TypeAsync("CNCRUN", "Yes");
        await talk.TypeAsync("CNCRUN", "C", "Y");
        var run = talk.Session.Machine.LastRun!;

        Assert.Equal(0.0, run.Judgement.MissingLengthMm);
        Assert.Equal(new CountsPoint(0, 0), run.Result.FinalPosition); // back at the drawing's start, both times
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCDISCONNECT"));
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCDISCONNECT"));
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCRUN"));
    }

    [Fact]
    public async Task Nothing_starts_without_a_typed_yes()
    {
        await using var talk = new CommandTalk();
        await talk.TypeAsync("OPEN", CommandTalk.Sample("paper-001.dxf"), "CNCCONNECT", "sim:", "CNCRUN");
        Assert.Equal("No", talk.Session.Prompt.Default);

        Assert.IsType<InputResult.Done>(await talk.TypeAsync(""));
        Assert.Null(talk.Session.Machine.LastRun);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCRUN", "Dryrun", "Yes"));
        Assert.Equal("none", talk.Session.Machine.LastRun!.Judgement.Source);
    }

    [Fact]
    public async Task While_a_job_runs_CNCSTOP_and_CNCSTATUS_are_heard_and_nothing_else()
    {
        await using var talk = new CommandTalk();
        using var limit = new CancellationTokenSource(TimeSpan.FromSeconds(60));
        await talk.TypeAsync("OPEN", CommandTalk.Sample("paper-001.dxf"), "CNCCONNECT", SlowMachine.Address, "CNCRUN");
        var moving = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        talk.Session.Machine.Changed += (_, _) => { if (talk.Session.Machine.Progress is not null) moving.TrySetResult(); };
        var job = talk.TypeAsync("Yes");
        await moving.Task.WaitAsync(limit.Token);

        Assert.True(talk.Session.IsBusy);
        Assert.IsType<InputResult.NotUnderstood>(await talk.TypeAsync("ERASE"));
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("'CNCSTATUS"));
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCSTOP"));
        Assert.Equal(CommandFailure.Stopped, Assert.IsType<InputResult.Failed>(await job.WaitAsync(limit.Token)).Why);
        Assert.False(talk.Session.Machine.IsRunning);
        Assert.Contains("RUNNING", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task An_address_that_is_none_or_nobody_answers_at_is_said_so()
    {
        await using var talk = new CommandTalk();
        using var listener = new System.Net.Sockets.TcpListener(System.Net.IPAddress.Loopback, 0);
        listener.Start();
        var port = ((System.Net.IPEndPoint)listener.LocalEndpoint).Port;
        listener.Stop();

        Assert.Equal(CommandFailure.Usage, Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCCONNECT", "somewhere")).Why);
        Assert.Equal(CommandFailure.LinkLost, Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCCONNECT", FormattableString.Invariant($"tcp://127.0.0.1:{port}"))).Why);
        Assert.Null(talk.Session.Machine.Description);
    }

    [Fact]
    public async Task Check_fails_on_a_drawing_with_errors_and_a_job_asks_first()
    {
        await using var talk = new CommandTalk();
        await File.WriteAllTextAsync(talk.PathOf("cut.dxf"), "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n0\n20\n0\n11\n3\n21\n4\n0\nLINE\n8\n0\n10\n0\n");

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("OPEN", "cut.dxf"));
        Assert.Equal(CommandFailure.Drawing, Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CHECK")).Why);
        Assert.Equal(CommandFailure.Drawing, Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCSIM", "")).Why);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCSIM", "Yes"));
    }

    [Fact]
    public async Task A_machine_profile_is_taken_from_a_file_and_a_bad_one_is_named()
    {
        await using var talk = new CommandTalk();
        await File.WriteAllTextAsync(talk.PathOf("good.json"), "{ \"feedMmPerMinute\": 300 }");
        await File.WriteAllTextAsync(talk.PathOf("bad.json"), "{\n\"feed\": 300 }");
        await talk.TypeAsync("CNCPROFILE", "good.json");

        Assert.Equal(300, talk.State.Settings.Machine.FeedMmPerMinute);
        Assert.Contains("bad.json(2)", Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCPROFILE", "bad.json")).Sentence, StringComparison.Ordinal);
    }
}
