using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Simulator;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>CNCCOMMISSION: the whole dialog, all its ends, and the resulting state of the controller.</summary>
public class CommissionCommandTests
{
    /// <summary>Step 4: both motors switch off on a following error above 500 counts.</summary>
    private static readonly string[] s_errorLimits = ["", "500", "Yes", "500", "Yes"];

    /// <summary>Every prompt of the dialog, with a switch sense that is tried and reverted.</summary>
    private static readonly string[] s_everything =
    [
        "", "", "", "", "", "", "", "", "", "", "", "High", "No", "", .. s_errorLimits,
        "", "2000", "1000", "Yes", "Left", "Yes", "Yes", "Back", "Yes", // A counts to the left
        "", "20000", "10000", "Yes", "5", "Yes", "", "Yes", "", "Yes", // A has 2000 counts/mm
        "", "", "Yes", "Right", "Front", // the F is on its side
        "", "3", "Yes", "Yes",
        "Yes", "mine.json", "No",
    ];

    public static TheoryData<int> Answers => [.. Enumerable.Range(0, s_everything.Length)];

    [Fact]
    public async Task The_whole_conversation_ends_with_the_profile_that_the_answers_describe()
    {
        await using var talk = await ConnectedAsync();

        var end = await talk.TypeAsync(s_everything);

        Assert.True(end is InputResult.Done, $"{talk.Session.Prompt.Text}\n{talk.Said}");
        var profile = MachineProfileSource.Load(talk.PathOf("mine.json"));
        Assert.Equal(('B', 1000.0), (profile.Axes.X.Letter, profile.Axes.X.CountsPerMillimetre));
        Assert.Equal(('A', 2000.0), (profile.Axes.Y.Letter, profile.Axes.Y.CountsPerMillimetre));
        Assert.Equal(3, profile.ToolOutput);
        Assert.Equal(MachineProfile.Default.FeedMmPerMinute, profile.FeedMmPerMinute);
        Assert.Equal(profile.Axes, talk.State.Settings.Machine.Axes); // It is used from now on.
        Assert.Contains("Not burned", talk.Said, StringComparison.Ordinal);
        Assert.Equal("500.0000 1.0000 0.0000 0.0000", await AskAsync(talk, "MG _ERA,_OEA,_RPA,_RPB"));
    }

    [Theory]
    [MemberData(nameof(Answers))]
    public async Task Esc_at_every_prompt_leaves_motors_outputs_and_what_was_not_accepted_as_found(int answers)
    {
        await using var talk = await ConnectedAsync("MOB", "SPA=7000");
        var found = await FingerprintAsync(talk);
        foreach (var answer in s_everything.Take(answers))
        {
            if (talk.Session.Prompt.Text.Contains("switched on and may jerk", StringComparison.Ordinal)) await talk.TypeAsync("Yes");
            await talk.TypeAsync(answer);
        }

        Assert.NotNull(talk.Session.Prompt.Command);
        var hasAccepted = talk.Said.Contains("following error limit set to", StringComparison.Ordinal);
        await talk.Session.CancelAsync();

        Assert.Null(talk.Session.Prompt.Command);
        Assert.Equal(found, await FingerprintAsync(talk));
        Assert.Equal(answers == s_everything.Length - 1, File.Exists(talk.PathOf("mine.json")));
        Assert.Equal(hasAccepted, talk.Said.Contains("until power-off:", StringComparison.Ordinal));
    }

    [Fact]
    public async Task Enter_alone_moves_nothing_changes_nothing_and_writes_nothing()
    {
        await using var talk = await ConnectedAsync();
        var found = await FingerprintAsync(talk);

        for (var i = 0; i < 100 && !talk.Session.Prompt.Text.StartsWith("Write these answers to a machine profile?", StringComparison.Ordinal); i++) await talk.TypeAsync("");
        Assert.IsType<InputResult.NotAccepted>(await talk.TypeAsync("")); // consent is typed
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("No"));

        Assert.Equal(found, await FingerprintAsync(talk));
        Assert.Equal("0.0000 0.0000", await AskAsync(talk, "MG _RPA,_RPB"));
        Assert.Equal(MachineProfile.Default.Axes, talk.State.Settings.Machine.Axes);
    }

    [Fact]
    public async Task A_motor_that_was_told_another_type_stays_off_and_that_is_said()
    {
        await using var talk = await ConnectedAsync();

        await talk.TypeAsync("Go", "Low", "Reversed", "Yes", "", "", "End", "No", "No");

        Assert.Null(talk.Session.Prompt.Command);
        Assert.Equal("2.5000 1.0000 0.0000", await AskAsync(talk, "MG _MTA,_MOA,_MOB"));
        Assert.Contains("The motor of axis A stays off", talk.Said, StringComparison.Ordinal);
        Assert.Contains("The controller keeps the settings until power-off.", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Nothing_moves_while_a_motor_is_off()
    {
        await using var talk = await ConnectedAsync("MOA");

        await talk.TypeAsync("Skip", "Skip", "Skip", "Skip", "Go", "", "", "No");

        Assert.Contains("Nothing is moved while a motor is off.", talk.Said, StringComparison.Ordinal);
        Assert.StartsWith("Step 6", talk.Session.Prompt.Text, StringComparison.Ordinal);
        Assert.Equal("1.0000 0.0000", await AskAsync(talk, "MG _MOA,_RPA"));
    }

    /// <summary>Regression: a step that was abandoned at its first move was reported as completed.</summary>
    [Fact]
    public async Task A_step_that_was_left_before_its_end_is_not_called_gone_through()
    {
        await using var talk = await ConnectedAsync();

        await talk.TypeAsync("Skip", "Skip", "Skip", "Go", "", "", "", "", "Go", "2000", "1000", "Yes", "Nothing"); // step 5: counts and does not move
        await talk.TypeAsync("Go", "", "", "No", "", "No"); // Step 6: the move is not possible.
        await talk.TypeAsync("Go", "", "No"); // step 7
        await talk.TypeAsync("Go", "3", "Yes", "Yes");

        Assert.StartsWith("Write these answers to a machine profile?", talk.Session.Prompt.Text, StringComparison.Ordinal);
        const CommissioningState LeftOut = CommissioningState.Skipped, Unfinished = CommissioningState.Unfinished;
        Assert.Equal([LeftOut, LeftOut, LeftOut, CommissioningState.Done, Unfinished, Unfinished, Unfinished, CommissioningState.Done], talk.Session.Commissioning.Steps.Select(step => step.State));
    }

    [Fact]
    public async Task A_file_that_exists_is_replaced_only_after_a_yes_and_a_place_that_cannot_be_written_loses_nothing()
    {
        await using var talk = await ConnectedAsync();
        await File.WriteAllTextAsync(talk.PathOf("mine.json"), "theirs");

        await talk.TypeAsync("End", "Yes", "mine.json", "No", "none/mine.json", "other.json");

        Assert.Null(talk.Session.Prompt.Command);
        Assert.Equal("theirs", await File.ReadAllTextAsync(talk.PathOf("mine.json")));
        Assert.Equal(MachineProfile.Default.Axes, MachineProfileSource.Load(talk.PathOf("other.json")).Axes);
    }

    [Fact]
    public async Task A_motor_that_runs_away_when_it_is_switched_on_is_off_at_once_and_after_its_sense_is_reversed_it_moves()
    {
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity, ReversedWiring = "A" });
        await using var talk = await ConnectedAsync(controller, "MOA");

        await talk.TypeAsync("Skip", "Skip", "Skip", "Go", "500", "Yes", "", "", "Go", "", "", "Yes");
        Assert.Contains("Axis A ran away", talk.Said, StringComparison.Ordinal);
        Assert.Equal("1.0000", await AskAsync(talk, "MG _MOA"));
        await talk.TypeAsync("Back", "Back", "Back", "Back", "Back", "Go", "Servo", "Reversed", "", "", "Skip", "Skip", "Skip", "Go", "", "", "Yes", "Yes", "Right", "Yes");

        Assert.Contains("the positive direction of the drawing has increasing counts", talk.Said, StringComparison.Ordinal);
        Assert.Equal("-1.0000", await AskAsync(talk, "MG _MTA"));
        await talk.Session.CancelAsync();
        Assert.Equal("1.0000", await AskAsync(talk, "MG _MOA")); // As found initially.
    }

    [Fact]
    public async Task An_axis_that_does_not_follow_its_command_has_its_motors_off_at_once_even_where_the_controller_would_leave_them_on()
    {
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        await using var talk = await ConnectedAsync(controller);
        await talk.TypeAsync("Skip", "Skip", "Skip", "Go", "100", "No", "", "No");
        controller.HoldMotor(0, true);

        await talk.TypeAsync("Go", "", "", "Yes");

        Assert.Contains("An axis did not follow its command or ran away. The motors are off.", talk.Said, StringComparison.Ordinal);
        Assert.Equal("1.0000 1.0000", await AskAsync(talk, "MG _MOA,_MOB"));
        await talk.Session.CancelAsync();
        Assert.Equal("1.0000 1.0000", await AskAsync(talk, "MG _MOA,_MOB")); // Nothing switches them on again.
    }

    [Fact]
    public async Task The_tools_output_is_on_for_half_a_second_and_one_that_is_on_already_is_left_alone()
    {
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        await using var talk = await ConnectedAsync(controller, "SB 2");
        for (var i = 0; i < 7; i++) await talk.TypeAsync("Skip");
        var before = controller.Record.Snapshot().Count;

        await talk.TypeAsync("Go", "2", "3", "Yes", "Yes");

        Assert.Contains("Output 2 is already on", talk.Said, StringComparison.Ordinal);
        Assert.Contains("Output 3 switches the tool.", talk.Said, StringComparison.Ordinal);
        var rows = controller.Record.Snapshot().Skip(before).ToList();
        var on = rows.First(row => (row.Outputs & 4) != 0);
        var off = rows.First(row => row.Sample > on.Sample && (row.Outputs & 4) == 0);
        Assert.InRange(off.Sample - on.Sample, 500, 700);
        Assert.All(rows, row => Assert.Equal(2, row.Outputs & 2));
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public async Task A_stop_in_a_move_brakes_the_axis_at_once_and_Esc_ends_the_conversation_too(bool isEsc)
    {
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        await using var talk = await ConnectedAsync(controller);
        await talk.TypeAsync("Skip", "Skip", "Skip", "Skip", "Go", "2000", "100000");
        var isPressed = 0;
        talk.Session.Machine.Changed += (_, _) =>
        {
            if (talk.Session.Machine.Status.MachinePosition is not { X: > 10.0 } || Interlocked.Exchange(ref isPressed, 1) != 0) return;
            if (isEsc) _ = talk.Session.CancelAsync();
            else talk.Session.Machine.Controls.Stop();
        };

        var result = await talk.TypeAsync("Yes");

        Assert.InRange(double.Parse(await AskAsync(talk, "MG _RPA"), System.Globalization.CultureInfo.InvariantCulture), 10_000, 50_000);
        Assert.Equal("0.0000 0.0000 0.0000", await AskAsync(talk, "MG _BGA,_MOA,_MOB"));
        if (isEsc) Assert.IsType<InputResult.Cancelled>(result);
        else Assert.StartsWith("Step 6", talk.Session.Prompt.Text, StringComparison.Ordinal); // The step was abandoned and can be repeated.
    }

    [Fact]
    public async Task No_script_commissions_a_machine_that_is_not_simulated()
    {
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        var end = await controller.ListenTcpAsync(0, CancellationToken.None);
        await using var talk = new CommandTestSession();
        await talk.TypeAsync("CNCCONNECT", FormattableString.Invariant($"tcp://127.0.0.1:{end.Port}"));
        await File.WriteAllTextAsync(talk.PathOf("a.scr"), "CNCCOMMISSION Skip Skip Skip Skip Go 500 1000 Yes\n");

        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("SCRIPT", "a.scr"));

        Assert.Contains("A script cannot commission tcp://127.0.0.1", talk.Said, StringComparison.Ordinal);
        Assert.Equal("0.0000", await AskAsync(talk, "MG _RPA"));
    }

    [Fact]
    public async Task A_link_that_is_lost_in_the_conversation_ends_it_with_a_sentence()
    {
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        await using var talk = await ConnectedAsync(controller);
        await talk.TypeAsync("Skip", "Skip", "Skip", "Skip", "Go", "2000", "100000");
        controller.DropConnections();

        var result = Assert.IsType<InputResult.Failed>(await talk.TypeAsync("Yes"));

        Assert.Equal(CommandFailure.LinkLost, result.Reason);
        Assert.Contains("The motors could not be returned to their initial state", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task With_an_axis_for_the_height_it_is_found_out_too_and_stays_where_it_is_while_others_move()
    {
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity });
        await using var talk = new CommandTestSession();
        var axes = MachineAxes.Default with { Z = new MachineAxis('C', 500.0) };
        talk.Session.Document.Commit("OPEN", talk.State with { Settings = talk.State.Settings with { Machine = MachineProfile.Default with { Axes = axes } } });
        await StartAsync(talk, await AddressAsync(controller), ["DPC=7000"]);
        var before = controller.Record.Snapshot().Count;

        await talk.TypeAsync("Skip", "Skip", "Skip", "Skip", "Go", "2000", "1000", "Yes", "Right", "Yes", "Yes", "Back", "Yes");
        Assert.All(controller.Record.Snapshot().Skip(before), row => Assert.Equal(7000, row.C));
        await talk.TypeAsync("Yes", "Down", "Yes"); // C
        await talk.TypeAsync("Go", "", "", "No", "", "No", "", "Yes", "2", "Yes"); // 500 counts of C are 2 mm
        var upToF = controller.Record.Snapshot().Count;
        await talk.TypeAsync("Go", "20000", "Yes", "Back", "Right", "Go", "3", "Yes", "Yes", "Yes", "three.json");

        Assert.Null(talk.Session.Prompt.Command);
        var rows = controller.Record.Snapshot();
        Assert.Contains(rows.Skip(upToF), row => row.B == 10_000);
        Assert.All(rows.Skip(upToF), row => Assert.Equal(7000, row.C));
        Assert.Equal((8000, 7000), (rows.Skip(before).Max(row => row.C), rows[^1].C));
        Assert.Equal(new MachineAxis('C', -250.0), MachineProfileSource.Load(talk.PathOf("three.json")).Axes.Z);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public async Task A_move_or_an_F_beyond_the_travel_of_the_profile_is_refused_in_millimetres_on_a_homed_machine_too(bool isHomed)
    {
        await using var talk = new CommandTestSession();
        var x = new MachineAxis('A', -1000.0) { Travel = new AxisTravel(-5, 1), Homing = isHomed ? new AxisHoming { By = HomingMark.Limit, Plus = true, Zero = 1.0, BackOff = 1.0 } : null };
        talk.Session.Document.Commit("OPEN", talk.State with { Settings = talk.State.Settings with { Machine = MachineProfile.Default with { Axes = MachineAxes.Default with { X = x } } } });
        await talk.TypeAsync("CNCCONNECT", "sim:");
        if (isHomed) Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCHOME", "Yes"));
        Assert.Equal("0.0000", await AskAsync(talk, "MG _RPA"));

        await talk.TypeAsync("CNCCOMMISSION", "Skip", "Skip", "Skip", "Skip", "Go", "", "6000", "Yes", "Back", "Go", "", "4000", "Yes");

        Assert.Contains("would take axis X to -6 mm; its travel is -5 to 1 mm", talk.Said, StringComparison.Ordinal);
        Assert.Equal("4000.0000", await AskAsync(talk, "MG _RPA"));
        await talk.TypeAsync("Keep", "No", "No", "Skip", "Go", "", "Yes"); // the F goes 6 mm towards plus, which is minus in counts
        Assert.Contains("would take axis X to 2 mm; its travel is -5 to 1 mm", talk.Said, StringComparison.Ordinal);
        Assert.Equal("4000.0000 0.0000", await AskAsync(talk, "MG _RPA,_RPB"));
    }

    private static Task<CommandTestSession> ConnectedAsync(params string[] lines) => ConnectedAsync("sim:", lines);

    private static async Task<CommandTestSession> ConnectedAsync(SimulatedController controller, params string[] lines) => await ConnectedAsync(await AddressAsync(controller), lines);

    private static async Task<CommandTestSession> ConnectedAsync(string address, string[] lines)
    {
        var talk = new CommandTestSession();
        await StartAsync(talk, address, lines);
        return talk;
    }

    private static async Task<string> AddressAsync(SimulatedController controller)
    {
        var end = await controller.ListenTcpAsync(0, CancellationToken.None);
        var clock = await controller.ListenClockAsync(CancellationToken.None);
        return FormattableString.Invariant($"tcp://127.0.0.1:{end.Port}?clock={clock.Port}");
    }

    private static async Task StartAsync(CommandTestSession talk, string address, string[] lines)
    {
        await talk.TypeAsync("CNCCONNECT", address);
        foreach (var line in lines) await talk.TypeAsync("CNCTERMINAL", line);
        Assert.IsType<InputResult.AwaitingInput>(await talk.TypeAsync("CNCCOMMISSION"));
    }

    private static Task<string> FingerprintAsync(CommandTestSession talk) => AskAsync(talk, "MG _MOA,_MOB,_OP0,_CN0,_CN1,_MTA,_MTB,_CEA,_CEB,_SPA,_ACA");

    /// <summary>Reply of the controller to a line.</summary>
    private static async Task<string> AskAsync(CommandTestSession talk, string line) => Assert.Single(await talk.Session.Machine.Connection.Terminal.TypeAsync(line, CancellationToken.None)).Text;
}
