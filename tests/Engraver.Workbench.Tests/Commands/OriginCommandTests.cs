using Engraver.Core.Geometry;
using Engraver.Workbench.Commands;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>CNCZERO sets the position of the drawing on the machine, CNCORIGIN selects one of the six work origins.</summary>
public class OriginCommandTests
{
    [Theory]
    [InlineData("CNCZERO")]
    [InlineData("CNCORIGIN")]
    public async Task Without_a_controller_there_is_no_origin(string command)
    {
        await using var talk = CommandTestSession.WithDrawing();

        var failed = Assert.IsType<InputResult.Failed>(await talk.TypeAsync(command));
        Assert.Equal(CommandFailure.Usage, failed.Reason);
        Assert.Contains("CNCCONNECT", failed.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task All_axes_are_zero_where_the_machine_stands()
    {
        await using var talk = await StandingAsync("12,-4");

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCZERO", "All"));
        Assert.Equal((12000, -4000), Active(talk));
        Assert.Equal(new Point2D(0, 0), talk.Session.Machine.Status.WorkPosition);
        Assert.EndsWith("Work origin G54: machine position X 12 mm, Y -4 mm.", talk.Said, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("X", 20000, -4000, 0.0, 9.0)]
    [InlineData("Y", 12000, 5000, 8.0, 0.0)]
    public async Task One_axis_is_set_and_the_other_keeps_its_place(string axis, int x, int y, double workX, double workY)
    {
        await using var talk = await StandingAsync("12,-4");
        await talk.TypeAsync("CNCZERO", "All", "CNCGOTO", "20,5");

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCZERO", axis, "Yes"));
        Assert.Equal((x, y), Active(talk));
        Assert.Equal(new Point2D(workX, workY), talk.Session.Machine.Status.WorkPosition);
    }

    /// <summary>The tool is outside of the workpiece: the zero is one radius farther in.</summary>
    [Theory]
    [InlineData("Left", 13500, 0, 12.0, 0.0)]
    [InlineData("Right", 10500, 0, 12.0, 0.0)]
    [InlineData("Bottom", 0, -2500, 0.0, -4.0)]
    [InlineData("Top", 0, -5500, 0.0, -4.0)]
    public async Task The_zero_lies_on_the_edge_that_the_tool_touches(string edge, int x, int y, double atX, double atY)
    {
        await using var talk = await StandingAsync("12,-4");

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCZERO", "Edges", edge, "1.5"));
        var origin = talk.Session.Machine.Connection.Lease!.Memory.ActiveOrigin!;
        Assert.Equal((atX != 0 ? x : (int?)null, atY != 0 ? y : (int?)null), (origin.X, origin.Y));
    }

    [Fact]
    public async Task Two_edges_give_both_axes_and_the_machine_is_moved_between_them()
    {
        await using var talk = await StandingAsync("12,-4");
        await talk.TypeAsync("CNCZERO", "Edges", "Left", "1.5", "CNCGOTO", "30,-10");
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCZERO", "Edges", "", "")); // The bottom edge is next, with the same radius.

        Assert.Equal((13500, -8500), Active(talk));
    }

    [Fact]
    public async Task The_zero_lies_in_the_middle_of_two_touches()
    {
        await using var talk = await StandingAsync("12,-4");
        await talk.TypeAsync("CNCZERO", "Centre");
        Assert.Contains("First touch at machine position 12,-4 mm", talk.Said, StringComparison.Ordinal);
        Assert.Empty(talk.Session.Machine.Connection.Lease!.Memory.Origins);
        await talk.TypeAsync("CNCGOTO", "20,5.001");

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCZERO", "Centre", "", "All"));
        Assert.Equal((16000, 501), Active(talk)); // half a count is rounded away from zero
        Assert.Null(talk.Session.Machine.Origins.FirstTouch);
        await talk.TypeAsync("CNCZERO", "Centre", "CNCDISCONNECT", "CNCCONNECT", "sim:");
        Assert.Null(talk.Session.Machine.Origins.FirstTouch); // another controller, another zero
    }

    [Fact]
    public async Task A_place_that_is_typed_is_where_the_machine_stands_in_the_drawing()
    {
        await using var talk = await StandingAsync("12,-4");

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCZERO", "Point", "2,1"));
        Assert.Equal((10000, -5000), Active(talk));
        Assert.Equal(new Point2D(2, 1), talk.Session.Machine.Status.WorkPosition);
    }

    [Fact]
    public async Task A_place_that_nobody_can_count_to_is_said_and_sets_nothing()
    {
        await using var talk = await StandingAsync("12,-4");

        Assert.Contains("32 bits", Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCZERO", "Point", "1e12,0")).Message, StringComparison.Ordinal);
        Assert.Empty(talk.Session.Machine.Connection.Lease!.Memory.Origins);
    }

    [Fact]
    public async Task What_is_set_is_asked_about_and_No_leaves_it()
    {
        await using var talk = await StandingAsync("12,-4");
        await talk.TypeAsync("CNCZERO", "All", "CNCGOTO", "20,5");

        Assert.IsType<InputResult.AwaitingInput>(await talk.TypeAsync("CNCZERO", "All"));
        Assert.Contains("G54 is already set", talk.Session.Prompt.Text, StringComparison.Ordinal);
        await talk.TypeAsync("No");
        Assert.Equal((12000, -4000), Active(talk));
    }

    [Fact]
    public async Task Only_the_axis_that_is_set_is_asked_about_and_half_an_origin_starts_no_job()
    {
        await using var talk = await StandingAsync("12,-4");

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCZERO", "Y"));
        Assert.Equal((null, -4000), Active(talk));
        Assert.Null(talk.Session.Machine.Status.WorkPosition);
        Assert.Contains("Work origin G54: machine position X (not set), Y -4 mm.", talk.Said, StringComparison.Ordinal);
        var refused = Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCRUN", "Yes"));
        Assert.Equal(CommandFailure.Refused, refused.Reason);
        Assert.Contains("The work origin G54 has no value for X.", talk.Said, StringComparison.Ordinal);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCZERO", "X"));
        Assert.Equal((12000, -4000), Active(talk));
        Assert.IsType<InputResult.AwaitingInput>(await talk.TypeAsync("CNCZERO", "Y"));
        await talk.TypeAsync("No");
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCRUN", "Yes"));
    }

    [Fact]
    public async Task Another_origin_is_chosen_by_its_name_and_the_first_keeps_its_place()
    {
        await using var talk = await StandingAsync("12,-4");
        await talk.TypeAsync("CNCZERO", "All");

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCORIGIN", "g55"));
        Assert.EndsWith("G55 is not set. This is the active work origin.", talk.Said, StringComparison.Ordinal);
        Assert.Null(talk.Session.Machine.Status.WorkPosition);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCGOTO", "1,1", "CNCZERO", "All"));
        Assert.Equal((1000, 1000), Active(talk));
        await talk.TypeAsync("CNCORIGIN", "G54");
        Assert.Equal((12000, -4000), Active(talk));
        Assert.Equal(new Point2D(-11, 5), talk.Session.Machine.Status.WorkPosition);
    }

    [Fact]
    public async Task The_list_has_all_six_and_changes_nothing()
    {
        await using var talk = await StandingAsync("12,-4");
        await talk.TypeAsync("CNCZERO", "All", "CNCORIGIN", "G56");

        await talk.TypeAsync("CNCORIGIN", "List");

        Assert.EndsWith(
            "Work origin G54: machine position X 12 mm, Y -4 mm.\nWork origin G55 is not set.\nWork origin G56 is not set. This is the active work origin.\nWork origin G57 is not set.\nWork origin G58 is not set.\nWork origin G59 is not set.",
            talk.Said,
            StringComparison.Ordinal);
        Assert.Equal("G56", talk.Session.Machine.Connection.Lease!.Memory.Active);
    }

    [Fact]
    public async Task An_origin_that_nobody_set_is_told_as_assumed_and_set_without_a_question()
    {
        await using var talk = await StandingAsync(null);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCRUN", "Yes"));

        await talk.TypeAsync("CNCORIGIN", "List");
        Assert.Contains("It was not set; the zero of the controller is assumed. This is the active work origin.", talk.Said, StringComparison.Ordinal);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCGOTO", "3,4", "CNCZERO", "All"));
        Assert.Equal((3000, 4000), Active(talk));
    }

    [Fact]
    public async Task A_stepper_without_current_is_doubted_until_its_origin_is_set_again()
    {
        await using var talk = await StandingAsync("12,-4");
        await talk.TypeAsync("CNCZERO", "All");
        foreach (var line in (string[])["MOA", "MTA=2"]) Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCTERMINAL", line));

        Assert.Equal(CommandFailure.Refused, Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCRUN", "Yes")).Reason);
        Assert.Contains("The machine position is not reliable: ", talk.Said, StringComparison.Ordinal);
        Assert.Contains("stepper", talk.Said, StringComparison.Ordinal);
        Assert.Equal((12000, -4000), Active(talk));
        await talk.TypeAsync("CNCTERMINAL", "SHA");
        Assert.Equal(CommandFailure.Refused, Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCRUN", "Yes")).Reason); // Powered again, it may have been moved by hand.
        await talk.TypeAsync("CNCZERO", "All");
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCRUN", "Yes"));
    }

    [Fact]
    public async Task On_a_machine_with_a_z_axis_every_sentence_of_an_origin_tells_its_height()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("CNCPROFILE", CommandTestSession.Sample("machine-mill.json"), "CNCCONNECT", "sim:", "CNCMOTORS", "ON", "CNCJOG", "12,-4", "CNCJOG", "Z+", "6.5");

        await talk.TypeAsync("CNCZERO", "Z");
        Assert.EndsWith("Work origin G54: machine position X (not set), Y (not set), Z 6.5 mm.", talk.Said, StringComparison.Ordinal);
        await talk.TypeAsync("CNCZERO", "All", "Yes", "CNCORIGIN", "List");
        Assert.Contains("Work origin G54: machine position X 12 mm, Y -4 mm, Z 6.5 mm.", talk.Said, StringComparison.Ordinal);
    }

    /// <summary>For example above a feeler gauge of 0.5 mm; every message about the current position shows it.</summary>
    [Fact]
    public async Task The_height_at_which_the_tool_stands_may_be_typed_and_every_sentence_about_the_place_tells_the_height()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("CNCCONNECT", "sim:");
        Assert.Contains("no Z axis", Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCZERO", "Height")).Message, StringComparison.Ordinal);
        await talk.TypeAsync("CNCDISCONNECT", "CNCPROFILE", CommandTestSession.Sample("machine-mill.json"), "CNCCONNECT", "sim:", "CNCMOTORS", "ON", "CNCJOG", "12,-4", "CNCJOG", "Z+", "6.5");
        Assert.EndsWith("Machine position: 12,-4,6.5 mm.", talk.Said, StringComparison.Ordinal);

        Assert.IsType<InputResult.NotAccepted>(await talk.TypeAsync("CNCZERO", "Height", "high"));
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("0.5"));
        Assert.Equal((null, null, 4800), (Active(talk).Item1, Active(talk).Item2, talk.Session.Machine.Connection.Lease!.Memory.ActiveOrigin?.Z));
        Assert.EndsWith("Z 6 mm.", talk.Said, StringComparison.Ordinal);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCZERO", "Height", "-1.25", "Yes")); // it was set
        Assert.Equal(6200, talk.Session.Machine.Connection.Lease.Memory.ActiveOrigin?.Z);
        Assert.Contains("32 bits", Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCZERO", "Height", "1e9", "Yes")).Message, StringComparison.Ordinal);

        await talk.TypeAsync("CNCZERO", "All", "Yes", "CNCJOG", "Z-", "1.5", "CNCSTATUS", "CNCARM", "Stream");
        Assert.Contains("machine 12,-4,5 mm, work 0,0,-1.5 mm", talk.Said, StringComparison.Ordinal);
        Assert.Contains("The drawing's zero is at machine position 12,-4,6.5 mm.", talk.Said, StringComparison.Ordinal);
    }

    [Fact]
    public async Task An_origin_may_be_typed_as_a_place_of_the_machine_with_its_height()
    {
        await using var talk = await StandingAsync("12,-4");

        Assert.IsType<InputResult.NotAccepted>(await talk.TypeAsync("CNCORIGIN", "Typed", "10,-3,6.5")); // without a Z axis
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("10,-3"));
        Assert.Equal((10000, -3000), Active(talk));
        Assert.Equal(new Point2D(2, -1), talk.Session.Machine.Status.WorkPosition);
        Assert.IsType<InputResult.AwaitingInput>(await talk.TypeAsync("CNCORIGIN", "Typed", "1,1"));
        await talk.TypeAsync("No");
        Assert.Equal((10000, -3000), Active(talk));
        Assert.Contains("32 bits", Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCORIGIN", "Typed", "1e12,0")).Message, StringComparison.Ordinal);

        await talk.TypeAsync("CNCDISCONNECT", "CNCPROFILE", CommandTestSession.Sample("machine-mill.json"), "CNCCONNECT", "sim:", "CNCORIGIN", "G56");
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCORIGIN", "Typed", "10,-3,6.5"));
        Assert.EndsWith("Work origin G56: machine position X 10 mm, Y -3 mm, Z 6.5 mm. This is the active work origin.", talk.Said, StringComparison.Ordinal);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCORIGIN", "Typed", "11,-3", "Yes"));
        Assert.EndsWith("X 11 mm, Y -3 mm, Z 6.5 mm. This is the active work origin.", talk.Said, StringComparison.Ordinal);
    }

    private static (long?, long?) Active(CommandTestSession talk) => (talk.Session.Machine.Connection.Lease!.Memory.ActiveOrigin?.X, talk.Session.Machine.Connection.Lease.Memory.ActiveOrigin?.Y);

    /// <param name="place">Where the simulated machine is moved to first; null for its zero.</param>
    private static async Task<CommandTestSession> StandingAsync(string? place)
    {
        var talk = CommandTestSession.WithDrawing();
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCCONNECT", "sim:"));
        if (place is not null) Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCGOTO", place));
        return talk;
    }
}
