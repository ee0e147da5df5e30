using Avalonia.Controls;
using Avalonia.Input;
using Engraver.App.SectionBreaks;
using Engraver.Core.Machines;
using Engraver.TestKit;
using Engraver.Workbench.Machines.Runs;

namespace Engraver.App.Tests.SectionBreaks;

/// <summary>A job that engraves marks twice with a stop between, and drills with another tool.</summary>
[Collection(DesktopCollection.Name)]
public sealed class SectionBreakTests(DesktopFixture fixture) : IDisposable
{
    private const string Operations = """
        { "version": "1.0", "tools": [{"number": 1, "name": "V", "diameter": 0.2}, {"number": 3, "name": "Drill", "diameter": 3}],
          "operations": [
            { "id": "a", "name": "Marks", "kind": "engrave", "select": {"layers": ["MARK"]}, "tool": 1, "depth": 0.2, "repeats": 2, "stopBetween": true },
            { "id": "b", "kind": "drill", "select": {"layers": ["HOLES"]}, "tool": 3, "depth": 1 }] }
        """;

    private readonly string _file = Path.Combine(Directory.CreateTempSubdirectory("sections-").FullName, "two.json");

    public void Dispose() => Directory.Delete(Path.GetDirectoryName(_file)!, recursive: true);

    [Fact]
    public Task The_panel_states_what_to_do_and_continues_each_section() => fixture.WithOperator(here =>
    {
        Run(here);
        Assert.Equal(("Section 1 of 3 is complete", "Repeat 2 of 2 of Marks: check the work, then continue. Do not change X and Y."), Shown(here));
        var part = here.Commands.Machine.Runs.Part!.Shown.Segments;
        Continue(here);
        Assert.Equal((JobOutcome.ToolChange, 2), (Last(here).Result.Outcome, Last(here).Section!.Number));
        Assert.True(here.Window.Canvas.EngravedMoves >= part);
        Assert.Equal(("Section 2 of 3 is complete", "Change tool V (1) to tool Drill (3), set the height of the work with it (CNCZERO, option Z), then continue. Do not change X and Y."), Shown(here));

        // Without the height of the new tool it asks first.
        Continue(here);
        Assert.Equal(("CNCCONTINUE", 2), (here.Desk.Prompt.Command, Last(here).Section!.Number));
        Assert.False(here.Window.Model.SectionBreak.Continue.CanExecute(null));
        here.Enter("No");
        here.Enter("CNCZERO", "Z", "Yes");
        Assert.StartsWith("Tool Drill (3): the height of the work is set.", Shown(here).Sentence, StringComparison.Ordinal);
        Continue(here);
        Assert.Equal((JobOutcome.Complete, 3), (Last(here).Result.Outcome, Last(here).Section!.Number));
        Assert.False(here.Find<SectionBreakView>("SectionBreak").IsEffectivelyVisible);
        Assert.Equal(1.0, here.Window.Model.Machine.Progress);
    });

    /// <summary>Neither a key nor a second click continues the job, nor a click in the first second.</summary>
    [Fact]
    public Task The_job_is_continued_by_one_deliberate_click_for_each_section() => fixture.WithOperator(
        here =>
        {
            Run(here, waits: false);
            here.Until(() => here.Window.Model.SectionBreak.IsOpen);
            Assert.False(here.Window.Model.SectionBreak.Continue.CanExecute(null));
            here.Until(() => here.Window.Model.SectionBreak.Continue.CanExecute(null));
            var first = Last(here);
            foreach (var key in (Key[])[Key.Enter, Key.Space, Key.Escape]) here.Hands.Press(key);
            here.WaitUntilIdle();
            Assert.Same(first, Last(here));
            here.Until(() => here.Window.Model.SectionBreak.Continue.CanExecute(null));

            here.Window.Model.SectionBreak.Continue.Execute(null);
            here.Window.Model.SectionBreak.Continue.Execute(null);
            here.WaitUntilIdle();
            Assert.Equal((2, null), (Last(here).Section!.Number, here.Desk.Prompt.Command));
        },
        clock: new ManualTimeProvider());

    [Fact]
    public Task Stop_leaves_the_rest_to_ARM_and_START() => fixture.WithOperator(here =>
    {
        Run(here);
        here.Click(here.Find<Button>("SectionStop"));
        Assert.False(here.Find<SectionBreakView>("SectionBreak").IsEffectivelyVisible);
        here.Click(here.Find<Button>("ArmKey"));
        here.WaitUntilIdle();
        here.Click(here.Find<Button>("StartKey"));
        here.WaitUntilIdle();

        Assert.Equal((JobOutcome.ToolChange, 2), (Last(here).Result.Outcome, Last(here).Section!.Number));
        Assert.True(here.Find<SectionBreakView>("SectionBreak").IsEffectivelyVisible);
    });

    /// <summary>The rest is resumed by its journal then.</summary>
    [Theory]
    [InlineData("CNCDISCONNECT", "CNCCONNECT", "sim:")]
    [InlineData("OPEN", "gasket.dxf")]
    [InlineData("CNCFEED", "333")]
    public Task The_question_is_gone_with_the_link_the_drawing_and_the_settings(params string[] words) => fixture.WithOperator(here =>
    {
        Run(here);
        var journal = Last(here).Journal!;
        here.Enter(words);
        DiscardEdits(here);
        Assert.False(here.Find<SectionBreakView>("SectionBreak").IsEffectivelyVisible);

        if (words[0] == "OPEN") Load(here);
        if (words[0] == "CNCFEED") here.Enter("U");
        here.Enter("CNCRESUME", journal);
        Assert.Contains(here.History, line => line.Contains("CNCARM and START cut the rest", StringComparison.Ordinal));
        Assert.False(here.Find<SectionBreakView>("SectionBreak").IsEffectivelyVisible);
    });

    /// <summary>Answers the question about the operations, which are not saved.</summary>
    private static void DiscardEdits(Operator here)
    {
        if (here.Window.Model.Files.Question is { IsOpen: true } question) question.Answers.Single(answer => answer.Name == "Files.OpenAnyway").Choose.Execute(null);
        here.WaitUntilIdle();
    }

    private void Load(Operator here)
    {
        File.WriteAllText(_file, Operations);
        here.Open("operation-plate.dxf");
        here.Enter("CNCPROFILE", Path.Combine(RepositoryFolder.Samples, "machine-mill.json"));
        var loading = here.Desk.Queue.RunAsync("OPERATION", "LOad", _file);
        here.Until(() => loading.IsCompleted);
        here.WaitUntilIdle();
    }

    private void Run(Operator here, bool waits = true)
    {
        Load(here);
        here.Enter("CNCCONNECT", "sim:", "CNCZERO", "All", "CNCARM", "Stream");
        here.Click(here.Find<Button>("StartKey"));
        if (!waits) return;
        here.WaitUntilIdle();
        Assert.True(here.Find<SectionBreakView>("SectionBreak").IsEffectivelyVisible);
    }

    private static void Continue(Operator here)
    {
        here.Until(() => here.Find<Button>("SectionContinue").IsEffectivelyEnabled);
        here.Click(here.Find<Button>("SectionContinue"));
        here.WaitUntilIdle();
    }

    private static (string? Title, string? Sentence) Shown(Operator here) => (here.Find<TextBlock>("SectionTitle").Text, here.Find<TextBlock>("SectionSentence").Text);

    private static MachineRunReport Last(Operator here) => here.Commands.Machine.Runs.LastRun!;
}
