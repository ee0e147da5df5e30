using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.VisualTree;
using Engraver.Core.Machines;
using Engraver.TestKit;
using Engraver.Workbench.Machines;

namespace Engraver.App.Tests.CommandWindow;

/// <summary>What the operator can do while a job runs: everything that only displays, and nothing that changes the drawing or the machine.</summary>
[Collection(DesktopCollection.Name)]
public sealed class ConcurrentCommandTests(DesktopFixture fixture)
{
    [Fact]
    public Task Typed_view_commands_and_queries_work_while_a_job_runs() => fixture.WithOperator(here =>
    {
        Start(here);
        var extents = here.Commands.View.Current.Height;
        Type(here, "zoom", "w", "0,0", "0.5,0.5");
        here.Until(() => here.Commands.View.Current.Height < extents / 2.0);
        Type(here, "dist", "0,0", "3,4");
        AssertAnswered(here, "Distance = 5");
        Type(here, "id", "1,2");
        AssertAnswered(here, "X = 1");
        Type(here, "list", "all", "");
        AssertAnswered(here, ", layer ");
        Type(here, "area", "0,0", "2,0", "2,2", "");
        AssertAnswered(here, "Area = 2");
        Type(here, "properties", "history", "list", "help", "zoom");
        AssertAnswered(here, "ZOOM");
        Type(here, "theme", "light");
        here.Until(() => here.Commands.View.Current.Theme.ToString() == "Light");
        Type(here, "ortho", "on", "pickbox", "7");
        here.Until(() => here.Commands.View.Current.Ortho && here.Window.Canvas.Pointing.PickBox == 7.0);

        AssertRunning(here);
        Assert.Null(here.Desk.Prompt.Command);
        End(here);
    });

    [Fact]
    public Task Menus_keys_and_clicks_on_the_canvas_work_too() => fixture.WithOperator(here =>
    {
        Start(here);
        here.Hands.Press(Key.F8);
        here.Until(() => here.Commands.View.Current.Ortho);
        here.Hands.Press(Key.F8);
        here.Until(() => !here.Commands.View.Current.Ortho);
        Type(here, "dist");
        here.Until(() => here.Desk.Prompt.Command == "DIST");
        var canvas = here.MiddleOf(here.Window.Canvas);
        here.Hands.Click(canvas);
        here.Until(() => here.Desk.Prompt.Text.StartsWith("Specify second point", StringComparison.Ordinal));
        here.Hands.Click(canvas + new Avalonia.Vector(40, 0));
        AssertAnswered(here, "Distance = ");
        var zoomed = here.Commands.View.Current.Height;
        Type(here, "zoom", "2x");
        here.Until(() => here.Commands.View.Current.Height < zoomed);
        here.Click(here.Find<ItemsControl>("ToolColumn").GetVisualDescendants().OfType<Button>().First(button => Equals(button.Tag, "ZOOM"))); // extents
        here.Until(() => here.Commands.View.Current.Height >= zoomed * 0.99);

        AssertRunning(here);
        End(here);
    });

    [Fact]
    public Task Objects_can_be_selected_and_asked_about_while_a_job_runs() => fixture.WithOperator(here =>
    {
        Start(here);
        Assert.Equal("Job running ... (Esc holds it)", here.Window.Model.Command.Instruction);
        _ = here.Desk.SelectAsync(_ => [1], remove: false);
        here.Until(() => here.Commands.Document.Current.Selection.Count == 1);
        Type(here, "list");
        AssertAnswered(here, "1 found");

        AssertRunning(here);
        End(here);
    });

    [Fact]
    public Task What_changes_the_drawing_or_the_machine_is_refused_with_the_reason() => fixture.WithOperator(here =>
    {
        (string Typed, string Reason)[] refused =
        [
            ("move", "MOVE can change the drawing"),
            ("open", "OPEN can change the drawing"),
            ("cncfeed", "CNCFEED can change the drawing"),
            ("cncgoto", "CNCGOTO acts on the machine"),
            ("cncrun", "CNCRUN acts on the machine"),
            ("cnczero", "CNCZERO acts on the machine"),
            ("nonsense", "'nonsense' cannot be used while"),
        ];
        Start(here);
        var before = here.Commands.Document.Current;
        foreach (var (typed, reason) in refused)
        {
            Type(here, typed);
            here.Until(() => here.History.Any(line => line.StartsWith(reason, StringComparison.Ordinal)));
            AssertRunning(here);
            Assert.Null(here.Desk.Prompt.Command);
        }

        End(here);

        Assert.Same(before, here.Commands.Document.Current);
        Assert.Null(here.Desk.Prompt.Command);
    });

    [Fact]
    public Task CNCSTOP_stops_though_something_else_asks_beside_the_job() => fixture.WithOperator(here =>
    {
        Start(here);
        Type(here, "dist", "0,0");
        here.Until(() => here.Desk.Prompt.Command == "DIST");
        Type(here, "cncstop");
        here.WaitUntilIdle();

        Assert.Equal(JobOutcome.Stopped, here.Commands.Machine.Runs.LastRun!.Result.Outcome);
        Assert.Null(here.Desk.Prompt.Command);
    });

    /// <summary>Esc holds the job, as always; a prompt of a concurrent command ends, and START continues the job.</summary>
    [Fact]
    public Task Escape_holds_the_job_and_ends_what_asks_beside_it() => fixture.WithOperator(here =>
    {
        Start(here);
        Type(here, "dist", "0,0");
        here.Until(() => here.Desk.Prompt.Command == "DIST");
        here.Hands.Press(Key.Escape);
        here.Until(() => here.Commands.Machine.Status.State == MachineState.Held && here.Desk.Prompt.Command is null);
        Assert.True(here.Commands.IsBusy);
        here.Until(() => here.Window.Model.Command.Instruction == "Job held (RESUME continues, STOP ends it)"); // and not that Esc ends the job, which it does not
        here.Click(here.Find<Button>("StartKey"));
        here.Until(() => here.Commands.Machine.Status.State == MachineState.Running);
        End(here);
    });

    /// <summary>Esc after quick typing, at any stage of processing the typed words: none of them opens a prompt or is kept until the job has ended. Input
    /// typed after Esc is accepted.</summary>
    [Fact]
    public Task Escape_ends_what_was_typed_before_it_however_far_that_has_come() => fixture.WithOperator(here =>
    {
        Start(here);
        foreach (var word in (string[])["list", "all", "", "dist", "0,0"]) _ = here.Desk.Queue.TypeAsync(word); // no part of it is processed before Esc
        here.Hands.Press(Key.Escape);
        here.Until(() => here.Desk.Queue.Cancelled.IsCompleted && here.Commands.Machine.Status.State == MachineState.Held);
        Type(here, "id", "1,2");
        AssertAnswered(here, "X = 1");

        Assert.Null(here.Desk.Prompt.Command);
        Assert.DoesNotContain(here.History, line => line.StartsWith("Distance", StringComparison.Ordinal) || line.Contains("kept", StringComparison.OrdinalIgnoreCase));
        End(here);
    });

    /// <summary>A prompt that is open when the job ends stays open and is answered as any other.</summary>
    [Fact]
    public Task A_question_outlives_the_job_beside_which_it_was_asked() => fixture.WithOperator(here =>
    {
        Start(here);
        Type(here, "dist", "0,0");
        here.Until(() => here.Desk.Prompt.Command == "DIST");
        here.Hands.Press(Key.Pause);
        here.WaitUntilIdle();
        Assert.Equal("DIST", here.Desk.Prompt.Command);
        here.Enter("6,8");

        Assert.Contains(here.History, line => line.StartsWith("Distance = 10", StringComparison.Ordinal));
        Assert.Null(here.Desk.Prompt.Command);
    });

    private static void Start(Operator here)
    {
        here.Open("gasket.dxf");
        here.Enter("CNCCONNECT", SlowSimulator.Address, "CNCARM", "Stream");
        here.Hands.Type("CNCRUN");
        here.Hands.Press(Key.Enter);
        here.Until(() => here.Commands.Machine.Status.State == MachineState.Running && here.Commands.Machine.Runs.Progress is { SegmentsSent: > 0 });
    }

    /// <summary>Types quickly, without waiting between two words.</summary>
    private static void Type(Operator here, params string[] words)
    {
        foreach (var word in words)
        {
            here.Hands.Type(word);
            here.Hands.Press(Key.Enter);
        }
    }

    private static void AssertAnswered(Operator here, string beginning) => here.Until(() => here.History.Any(line => line.TrimStart().Contains(beginning, StringComparison.Ordinal)));

    private static void AssertRunning(Operator here) => Assert.Equal((true, MachineState.Running), (here.Commands.Machine.IsRunning, here.Commands.Machine.Status.State));

    private static void End(Operator here)
    {
        here.Hands.Press(Key.Pause);
        here.WaitUntilIdle();
        Assert.Equal(JobOutcome.Stopped, here.Commands.Machine.Runs.LastRun!.Result.Outcome);
    }
}
