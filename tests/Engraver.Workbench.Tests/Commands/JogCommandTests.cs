using Engraver.Core.Machines;
using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>CNCJOG on a simulated controller that is connected as the desktop connects it.</summary>
public sealed class JogCommandTests : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-jog-");
    private readonly List<string> _said = [];

    [Fact]
    public async Task CNCJOG_moves_by_a_step_and_by_a_distance_which_is_remembered()
    {
        await using var session = await ConnectedAsync();

        Assert.IsType<InputResult.Done>(await TypeAsync(session, "CNCJOG", "0.01,-2.5"));
        Assert.Equal((0.01, -2.5), At(session));
        Assert.IsType<InputResult.Done>(await TypeAsync(session, "CNCJOG", "x+", "10"));
        Assert.Equal((10.01, -2.5), At(session));
        Assert.IsType<InputResult.Done>(await TypeAsync(session, "CNCJOG", "Y-", ""));
        Assert.Equal((10.01, -12.5), At(session));
    }

    [Fact]
    public async Task CNCJOG_Continuous_moves_to_the_end_of_the_travel_at_the_latest()
    {
        await using var session = await ConnectedAsync(Travel(0, 30, -20, 20));

        await TypeAsync(session, "CNCJOG", "X+");
        var asked = await session.EnterAsync("Continuous", CancellationToken.None);
        Assert.IsType<InputResult.AwaitingInput>(asked);
        using var alive = new FrontEnd(session.Machine);
        await StandsAtAsync(session, 30.0);
        Assert.IsType<InputResult.Done>(await TypeAsync(session, ""));

        Assert.Equal((30.0, 0.0), At(session));
    }

    [Theory]
    [InlineData("CNCJOG", "31,0")]
    [InlineData("CNCGOTO", "5,-20.001")]
    public async Task A_move_that_would_leave_the_travel_is_refused_before_a_byte_of_motion(string command, string place)
    {
        await using var session = await ConnectedAsync(Travel(0, 30, -20, 20));

        var failed = Assert.IsType<InputResult.Failed>(await TypeAsync(session, command, place));

        Assert.Contains("its travel is", failed.Message, StringComparison.Ordinal);
        Assert.Equal((0.0, 0.0), At(session));
        Assert.IsType<InputResult.Done>(await TypeAsync(session, "CNCGOTO", "30,-20"));
    }

    [Fact]
    public async Task A_job_that_would_leave_the_travel_is_not_armed_and_not_run()
    {
        await using var session = await ConnectedAsync(Travel(-1, 3, -1, 1));

        Assert.IsType<InputResult.Failed>(await TypeAsync(session, "CNCARM", "Stream"));
        Assert.Contains(_said, line => line.Contains("axis X to 5 mm", StringComparison.Ordinal));
        Assert.IsType<InputResult.Failed>(await TypeAsync(session, "CNCRUN", "Yes"));
        Assert.Equal((0.0, 0.0), At(session));
    }

    [Fact]
    public async Task What_cannot_jog_is_refused_with_what_to_do()
    {
        await using var session = NewSession();
        Assert.Contains("CNCCONNECT", Assert.IsType<InputResult.Failed>(await TypeAsync(session, "CNCJOG")).Message, StringComparison.Ordinal);
        await TypeAsync(session, "CNCCONNECT", "sim:?speed=max");
        Assert.IsType<InputResult.NotAccepted>(await TypeAsync(session, "CNCJOG", "Q+"));
        await TypeAsync(session, "0,0");
        await TypeAsync(session, "CNCMOTORS", "OFF");
        Assert.Contains("CNCMOTORS ON", Assert.IsType<InputResult.Failed>(await TypeAsync(session, "CNCJOG", "X+", "Continuous")).Message, StringComparison.Ordinal);
        await File.WriteAllTextAsync(Path.Combine(_folder.FullName, "hold.scr"), "CNCMOTORS ON\nCNCJOG X+ Continuous\n");
        Assert.Contains("A script cannot jog continuously", Assert.IsType<InputResult.Failed>(await TypeAsync(session, "SCRIPT", "hold.scr")).Message, StringComparison.Ordinal);
    }

    public void Dispose() => _folder.Delete(recursive: true);

    private static MachineProfile Travel(double leastX, double mostX, double leastY, double mostY) => MachineProfile.Default with
    {
        Axes = MachineProfile.Default.Axes with
        {
            X = MachineProfile.Default.Axes.X with { Travel = new AxisTravel(leastX, mostX) },
            Y = MachineProfile.Default.Axes.Y with { Travel = new AxisTravel(leastY, mostY) },
        },
    };

    private static (double X, double Y) At(CommandSession session) => (session.Machine.Status.MachinePosition!.Value.X, session.Machine.Status.MachinePosition!.Value.Y);

    private static async Task StandsAtAsync(CommandSession session, double x)
    {
        var there = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        void Look(object? sender, EventArgs e)
        {
            if (!session.Machine.IsRunning && session.Machine.Status.MachinePosition?.X == x) there.TrySetResult();
        }

        session.Machine.Changed += Look;
        Look(null, EventArgs.Empty);
        await there.Task.WaitAsync(TimeSpan.FromSeconds(120));
        session.Machine.Changed -= Look;
    }

    private CommandSession NewSession(MachineProfile? profile = null)
    {
        var session = new CommandSession(new CommandEnvironment { Folder = _folder.FullName, RunJournalFolder = _folder.FullName }, CommandCatalog.Built());
        session.MessageWritten += (_, message) => _said.Add(message.Text);
        var state = new DocumentState { Drawing = new DrawingBuilder().Line(0, 0, 5, 0).Build() };
        session.Document.Commit("OPEN", profile is null ? state : state with { Settings = state.Settings with { Machine = profile } });
        return session;
    }

    private async Task<CommandSession> ConnectedAsync(MachineProfile? profile = null)
    {
        var session = NewSession(profile);
        Assert.IsType<InputResult.Done>(await TypeAsync(session, "CNCCONNECT", "sim:?speed=max"));
        return session;
    }

    private static async Task<InputResult> TypeAsync(CommandSession session, params string[] inputs)
    {
        InputResult result = new InputResult.Done();
        foreach (var input in inputs) result = await session.EnterAsync(input, CancellationToken.None);
        return result;
    }
}
