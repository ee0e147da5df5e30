using System.Text;
using Engraver.Core.Machines;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines;

namespace Engraver.Workbench.Tests.Machines;

/// <summary>The frame run before a job: checked by the simulator's counts, tool off.</summary>
public sealed class FrameTests : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-frame-");

    [Theory]
    [InlineData(FrameShape.Rectangle)]
    [InlineData(FrameShape.Hull)]
    public async Task The_frame_is_gone_round_at_the_origin_that_is_set_and_the_tool_is_never_on(FrameShape shape)
    {
        await using var bench = await MachineBench.ConnectedAsync();
        await bench.Machine.Origins.SetAsync((memory, _) => memory.WithOrigin("G54", 3000, 2000, null), bench.Limit);
        var before = bench.Controller.Record.Snapshot().Count;

        var states = new List<MachineState>();
        bench.Machine.Changed += (_, _) => states.Add(bench.Machine.Status.State);
        var result = await bench.Machine.Runs.FrameAsync(JobFrame.Of(MachineBench.Job(), shape)!, Path.Combine(_folder.FullName, "frame.jsonl"), bench.Limit);

        Assert.True(result.Outcome == JobOutcome.Complete, result.Message);
        var samples = bench.Controller.Record.Snapshot().Skip(before).ToList();
        Assert.All(samples, sample => Assert.Equal(0, sample.Outputs));
        Assert.Equal((48000L, 7000L), ((long)samples.Max(sample => sample.A), (long)samples.Max(sample => sample.B))); // 45, 5 of the drawing
        Assert.Contains(MachineState.Moving, states);
        Assert.DoesNotContain(MachineState.Running, states);
        Assert.Null(bench.Machine.Status.LastOutcome); // It was not a job.
    }

    [Fact]
    public async Task Without_an_origin_nothing_moves_and_the_state_says_what_to_do()
    {
        await using var bench = await MachineBench.ConnectedAsync();
        await bench.Machine.Hand.GoToAsync(new CountsPoint(5000, 0), Path.Combine(_folder.FullName, "goto.jsonl"), feed: null, bench.Limit);
        Assert.Equal(MachineState.NoOrigin, bench.Machine.Status.State);
        Assert.Contains("CNCZERO", bench.Machine.Status.Reason, StringComparison.Ordinal);
        var before = bench.Controller.Record.Snapshot().Count;

        var result = await bench.Machine.Runs.FrameAsync(JobFrame.Of(MachineBench.Job(), FrameShape.Rectangle)!, Path.Combine(_folder.FullName, "frame.jsonl"), bench.Limit);

        Assert.Equal((JobOutcome.Refused, "JOB0008", before), (result.Outcome, Assert.Single(result.Diagnostics).Id, bench.Controller.Record.Snapshot().Count));
        await bench.Machine.Origins.SetAsync((memory, here) => memory.WithOrigin("G54", here.Position.X, here.Position.Y, null), bench.Limit);
        Assert.Equal(MachineState.Ready, bench.Machine.Status.State);
        Assert.Null(bench.Machine.Origins.Choose("G55"));
        Assert.Equal(MachineState.NoOrigin, bench.Machine.Status.State);
    }

    /// <summary>The controller monitors the travel too, as during jobs and jogs, and its own limits are restored.</summary>
    [Fact]
    public async Task On_its_way_round_the_controller_has_the_travel_as_soft_limits_and_afterwards_its_own()
    {
        await using var bench = await MachineBench.ConnectedAsync();
        Assert.Equal(":::", Ask(bench, "FLA=900000\rBLA=-900000\rFLB=800000\r"));
        var axes = MachineProfile.Default.Axes;
        bench.Machine.Profile = MachineProfile.Default with { Axes = axes with { X = axes.X with { Travel = new AxisTravel(-10, 155) }, Y = axes.Y with { Travel = new AxisTravel(-20, 200) } } };
        var job = MachineBench.Job(bench.Machine.Profile);
        var under = "";
        bench.Machine.Changed += (_, _) =>
        {
            if (under.Length == 0 && bench.Machine.Status is { State: MachineState.Moving, MachinePosition.X: > 10.0 }) under = Ask(bench, Limits);
        };

        var result = await bench.Machine.Runs.FrameAsync(JobFrame.Of(job, FrameShape.Rectangle)!, Path.Combine(_folder.FullName, "frame.jsonl"), bench.Limit);

        Assert.True(result.Outcome == JobOutcome.Complete, result.Message);
        Assert.Equal(" 155001.0000 -10001.0000 200001.0000 -20001.0000\r\n:", under);
        Assert.Equal(" 900000.0000 -900000.0000 800000.0000 -2147483648.0000\r\n:", Ask(bench, Limits));
    }

    private const string Limits = "MG _FLA,_BLA,_FLB,_BLB\r";

    private static string Ask(MachineBench bench, string commands)
    {
        using var link = bench.Controller.OpenConnection();
        link.Write(Encoding.ASCII.GetBytes(commands));
        var answer = new byte[1000];
        return Encoding.ASCII.GetString(answer, 0, link.Read(answer));
    }

    /// <summary>One list states before any motion which limit the placed job would exceed, and what to do.</summary>
    [Fact]
    public async Task A_job_that_would_leave_the_travel_is_on_the_list_and_is_neither_armed_nor_framed()
    {
        await using var talk = new Commands.CommandTestSession();
        await talk.TypeAsync("OPEN", Commands.CommandTestSession.Sample("paper-001.dxf"), "CNCCONNECT", "sim:");
        var axes = MachineProfile.Default.Axes;
        var state = talk.Session.Document.Current;
        var profile = MachineProfile.Default with { Axes = axes with { X = axes.X with { Travel = new AxisTravel(-10, 155) }, Y = axes.Y with { Travel = new AxisTravel(-10, 200) } } };
        talk.Session.Document.Commit("PROFILE", state with { Settings = state.Settings with { Machine = profile } });
        await talk.TypeAsync("CNCARM", "Stream");
        Assert.True(talk.Said.Contains("ok     The placed job is inside the travel of the machine.", StringComparison.Ordinal), talk.Said);

        await talk.TypeAsync("CNCGOTO", "10,0", "CNCZERO", "All"); // 150 mm of drawing from here end at 160

        Assert.Equal(CommandFailure.Refused, Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCARM", "Stream")).Reason);
        Assert.Contains(talk.Said.Split('\n'), line => line.StartsWith("NOT OK The move would take axis X to 160 mm; its travel is -10 to 155 mm.", StringComparison.Ordinal));
        Assert.Equal(CommandFailure.Refused, Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCFRAME", "Rectangle")).Reason);
        Assert.Equal(10.0, talk.Session.Machine.Status.MachinePosition!.Value.X);
    }

    [Fact]
    public async Task CNCFRAME_goes_round_what_is_open_and_says_so()
    {
        await using var talk = new Commands.CommandTestSession();
        await talk.TypeAsync("OPEN", Commands.CommandTestSession.Sample("paper-001.dxf"), "CNCCONNECT", "sim:");

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCFRAME", "Hull"));
        Assert.Contains("Frame complete. The tool was off.", talk.Said, StringComparison.Ordinal);
        Assert.Equal("CNCFRAME", talk.Session.Catalog.Find("cncframe")!.Info.Name);
        Assert.Null(talk.Session.Machine.Runs.LastRun);
    }

    public void Dispose() => _folder.Delete(recursive: true);
}
