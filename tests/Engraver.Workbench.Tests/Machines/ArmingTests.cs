using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Galil.Language;
using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Arming;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Machines;

public class ArmingTests
{
    [Fact]
    public async Task Arming_lasts_a_minute()
    {
        await using var bench = await MachineBench.ConnectedAsync();
        var begun = bench.Time.GetUtcNow();
        Arm(bench);

        // Advance poll by poll: advancing a whole minute at once would let a pending query time out.
        var status = await bench.UntilAsync(status => status.State != MachineState.Armed);

        Assert.Equal(MachineState.Ready, status.State);
        Assert.InRange(bench.Time.GetUtcNow() - begun, TimeSpan.FromSeconds(59.9), TimeSpan.FromSeconds(60.5));
        Assert.Null(bench.Machine.Arming.Armed);
    }

    [Fact]
    public async Task Anything_that_changes_at_the_machine_takes_it_back()
    {
        await using var bench = await MachineBench.ConnectedAsync();
        Arm(bench);
        bench.Controller.SetInput(3, level: false);

        var until = bench.Machine.Arming.Armed!.Until;
        var status = await bench.UntilAsync(status => status.State == MachineState.Ready);

        Assert.True(status.Time < until - TimeSpan.FromSeconds(50), "it was the minute that ended it");
        Assert.Null(bench.Machine.Arming.Armed);
    }

    [Fact]
    public async Task A_stop_an_abort_a_typed_line_another_profile_and_disconnecting_take_it_back()
    {
        await using var bench = await MachineBench.ConnectedAsync();
        Action[] changes =
        [
            () => bench.Machine.Controls.Stop(),
            () => bench.Machine.Profile = bench.Machine.Profile with { FeedMmPerMinute = 600 },
            () => bench.Machine.Arming.Disarm(),
        ];
        foreach (var change in changes)
        {
            Arm(bench);
            change();
            Assert.Null(bench.Machine.Arming.Armed);
        }

        Arm(bench);
        await bench.Machine.Connection.Terminal.TypeAsync("MG 1", bench.Limit);
        Assert.Null(bench.Machine.Arming.Armed);
        Arm(bench);
        await bench.Machine.Connection.DisconnectAsync();
        Assert.Null(bench.Machine.Arming.Armed);
    }

    [Fact]
    public void The_checklist_names_what_is_missing()
    {
        var nothing = JobPreparation.Prepare(new DrawingBuilder().Build(), new DrawingSettings(), MotionStyle.Continuous);
        var offline = ArmingChecklist.Create(nothing, MachineStatus.Offline, errorsAccepted: false, MachineBench.Placed, default);
        var limit = ArmingChecklist.Create(MachineBench.Job(), new MachineStatus { State = MachineState.Fault, Link = "x", MotorsOn = true, Limit = "the forward limit of axis A" }, errorsAccepted: false, MachineBench.Placed, default);
        var ready = ArmingChecklist.Create(MachineBench.Job(), new MachineStatus { State = MachineState.Ready, Link = "x", MotorsOn = true }, errorsAccepted: false, MachineBench.Placed, default);

        Assert.Equal([true, false, false, true], offline.Checks.Select(check => check.Passed));
        Assert.Equal([true, true, true, false, true, false, true, true], limit.Checks.Select(check => check.Passed));
        Assert.True(ready.Passed);
    }

    /// <summary>A check passes only with current data: with a dead link its state is unknown.</summary>
    [Fact]
    public void Nothing_that_a_dead_or_silent_link_said_has_a_tick()
    {
        var ready = new MachineStatus { State = MachineState.Ready, Link = "tcp://x", MotorsOn = true };
        var lost = ArmingChecklist.Create(MachineBench.Job(), ready with { State = MachineState.Fault, IsLinkLost = true }, errorsAccepted: false, MachineBench.Placed, default);
        var silent = ArmingChecklist.Create(MachineBench.Job(), ready, errorsAccepted: false, MachineBench.Placed, default(DateTimeOffset) + TimeSpan.FromSeconds(5.5));

        Assert.Contains(lost.Checks, check => check is { Passed: false, IsCurrent: true } && check.Message.StartsWith("The link to tcp://x is lost; ", StringComparison.Ordinal));
        Assert.Contains(silent.Checks, check => check is { Passed: false, IsCurrent: true } && check.Message.StartsWith("tcp://x has not replied for 5 s; ", StringComparison.Ordinal));
        foreach (var list in new[] { lost, silent })
        {
            Assert.Equal(5, list.Checks.Count(check => check is { Passed: false, IsCurrent: false } && check.Message.StartsWith("Not known now; ", StringComparison.Ordinal)));
            Assert.Equal(["The drawing has no errors.", "The job has 2 segments."], list.Checks.Where(check => check.Passed).Select(check => check.Message));
        }
    }

    [Fact]
    public async Task ARM_asks_the_controller_and_a_dead_link_is_found_then()
    {
        await using var bench = await MachineBench.ConnectedAsync();
        var job = MachineBench.Job();
        Assert.NotNull(await bench.Machine.Origins.AskAsync(job.Motion.Program!, dryRun: false, bench.Limit));
        await bench.Controller.DisposeAsync();

        Assert.Null(await bench.Machine.Origins.AskAsync(job.Motion.Program!, dryRun: false, bench.Limit)); // not checked since
        Assert.Equal((MachineState.Fault, true), (bench.Machine.Status.State, bench.Machine.Status.IsLinkLost));
    }

    [Fact]
    public async Task The_status_goes_through_the_same_list_with_what_to_do()
    {
        await using var talk = new Commands.CommandTestSession();
        await talk.TypeAsync("CNCCONNECT", "sim:", "CNCMOTORS", "OFF", "CNCSTATUS");
        Assert.Contains("ok     The link to sim: is up; the controller has just replied.", talk.Said, StringComparison.Ordinal);
        Assert.Contains("NOT OK The motors are off; switch them on with CNCMOTORS ON.", talk.Said, StringComparison.Ordinal);
        Assert.Contains("ok     The abort input is not active.", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Units_that_were_assumed_are_on_the_list()
    {
        await using var talk = new Commands.CommandTestSession();
        var file = Path.Combine(Directory.CreateTempSubdirectory("engraver-units-").FullName, "no-unit.dxf");
        await File.WriteAllTextAsync(file, (await File.ReadAllTextAsync(Commands.CommandTestSession.Sample("paper-001.dxf"))).Replace("$INSUNITS", "$NOUNITS", StringComparison.Ordinal));
        await talk.TypeAsync("OPEN", file, "CNCCONNECT", "sim:", "CNCARM", "Stream");
        Assert.Contains(talk.Said.Split('\n'), line => line.StartsWith("WARN   The drawing does not state its unit", StringComparison.Ordinal));
        Directory.Delete(Path.GetDirectoryName(file)!, recursive: true);
    }

    [Fact]
    public async Task After_a_job_that_was_stopped_the_list_says_so_and_the_next_one_goes_to_the_same_place()
    {
        await using var talk = new Commands.CommandTestSession();
        using var limit = new CancellationTokenSource(TimeSpan.FromSeconds(60));
        await talk.TypeAsync("OPEN", Commands.CommandTestSession.Sample("paper-001.dxf"), "CNCCONNECT", "sim:?speed=4", "CNCARM", "Stream");
        Assert.DoesNotContain("WARN", talk.Said, StringComparison.Ordinal);
        var cutting = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        talk.Session.Machine.Changed += (_, _) => { if (talk.Session.Machine.Status is { ToolCommanded: true, WorkPosition.X: > 60 }) cutting.TrySetResult(); };
        var job = talk.TypeAsync("CNCRUN");
        await cutting.Task.WaitAsync(limit.Token);
        talk.Session.Machine.Controls.Stop();
        await job.WaitAsync(limit.Token);

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCARM", "Stream"));
        var said = talk.Said.Split('\n').Last(line => line.StartsWith("WARN", StringComparison.Ordinal));
        Assert.Contains("The last job on this machine ended early: stopped by the operator.", said, StringComparison.Ordinal);
        Assert.Contains("The drawing's zero is at machine position 0,0 mm.", talk.Said, StringComparison.Ordinal); // Set by the first job, wherever the stop left the machine.
        Assert.True(Assert.Single(talk.Session.Machine.Arming.Armed!.Checklist.Checks, check => check.IsWarning).Passed);
    }

    [Fact]
    public void A_job_without_a_place_is_not_armed_and_the_list_says_why_and_what_to_do()
    {
        var stands = new ControllerPosition(new CountsPoint(5000, 0));
        var nowhere = WorkPlacement.Find(StoredMachineState.Empty, stands, new OriginRequest.ActiveOrigin(), MachineProfile.Default, default);
        var ready = new MachineStatus { State = MachineState.Ready, Link = "x", MotorsOn = true };

        var refused = ArmingChecklist.Create(MachineBench.Job(), ready, errorsAccepted: false, nowhere, default);
        Assert.False(refused.Passed);
        Assert.Contains("G54 is not set on this machine. The machine position is 5, 0 mm", Assert.Single(refused.Checks, check => !check.Passed).Message, StringComparison.Ordinal);
        Assert.Contains("CNCZERO", Assert.Single(refused.Checks, check => !check.Passed).Message, StringComparison.Ordinal);
        Assert.False(ArmingChecklist.Create(MachineBench.Job(), ready, errorsAccepted: false, placement: null, default).Passed);
        var placed = ArmingChecklist.Create(MachineBench.Job(), ready, errorsAccepted: false, new PlacementResult(new CountsPoint(12500, -3000), OriginSource.Work, null), default);
        Assert.True(placed.Passed);
        Assert.Contains(placed.Checks, check => check.Message.Contains("zero is at machine position 12.5,-3 mm", StringComparison.Ordinal));
    }

    [Fact]
    public async Task What_was_not_checked_cannot_be_armed()
    {
        await using var bench = await MachineBench.ConnectedAsync();
        var failed = new ArmingChecklist([new ArmingCheck(false, "no")]);

        Assert.Throws<InvalidOperationException>(() => bench.Machine.Runs.Arm(MachineBench.Job(), JobMode.Stream.Strategy(), dryRun: false, failed));
    }

    [Fact]
    public async Task CNCRUN_of_what_was_armed_asks_nothing_and_is_armed_no_more()
    {
        await using var talk = new Commands.CommandTestSession();
        await talk.TypeAsync("OPEN", Commands.CommandTestSession.Sample("paper-001.dxf"), "CNCCONNECT", "sim:", "CNCARM", "Dryrun", "Stream");
        Assert.Equal(MachineState.Armed, talk.Session.Machine.Status.State);

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCRUN"));

        Assert.Equal(JobOutcome.Complete, talk.Session.Machine.Runs.LastRun!.Result.Outcome);
        Assert.Equal("none", talk.Session.Machine.Runs.LastRun.Judgement.Source);
        Assert.Null(talk.Session.Machine.Arming.Armed);
        Assert.IsType<InputResult.AwaitingInput>(await talk.TypeAsync("CNCRUN"));
    }

    [Fact]
    public async Task An_edit_or_another_setting_disarms_and_a_selection_does_not()
    {
        await using var talk = new Commands.CommandTestSession();
        await talk.TypeAsync("OPEN", Commands.CommandTestSession.Sample("paper-001.dxf"), "CNCCONNECT", "sim:", "CNCARM", "Stream", "SELECT", "ALL", "");
        Assert.Equal(MachineState.Armed, talk.Session.Machine.Status.State);

        await talk.TypeAsync("CNCMAXERR", "0.02");
        Assert.Equal(MachineState.Ready, talk.Session.Machine.Status.State);
        await talk.TypeAsync("CNCARM", "Stream", "REVERSE", "ALL", "");
        Assert.Equal(MachineState.Ready, talk.Session.Machine.Status.State);
    }

    [Fact]
    public async Task Motors_that_are_off_are_on_the_list_and_nothing_is_armed()
    {
        await using var talk = new Commands.CommandTestSession();
        await talk.TypeAsync("OPEN", Commands.CommandTestSession.Sample("paper-001.dxf"), "CNCCONNECT", "sim:", "CNCMOTORS", "OFF");

        Assert.Equal(CommandFailure.Refused, Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCARM", "Stream")).Reason);
        await talk.TypeAsync("CNCSTATUS");
        Assert.Contains("state MOTORS OFF (motor off: XY), machine 0,0 mm", talk.Said, StringComparison.Ordinal);
        Assert.Contains("NOT OK The motors are off; switch them on with CNCMOTORS ON.", talk.Said, StringComparison.Ordinal);
        await talk.TypeAsync("CNCMOTORS", "ON");
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCARM", "Stream"));
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCARM", "F"));
        Assert.Null(talk.Session.Machine.Arming.Armed);
    }

    private static void Arm(MachineBench bench)
    {
        var job = MachineBench.Job();
        bench.Machine.Runs.Arm(job, JobMode.Stream.Strategy(), dryRun: false, ArmingChecklist.Create(job, bench.Machine.Status, errorsAccepted: false, MachineBench.Placed, bench.Time.GetUtcNow()));
        Assert.Equal(MachineState.Armed, bench.Machine.Status.State);
    }
}
