using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.VisualTree;
using Engraver.App.Commissioning;

namespace Engraver.App.Tests.Commissioning;

/// <summary>The commissioning page: the same conversation as CNCCOMMISSION, with its steps and buttons for its answers.</summary>
[Collection(DesktopCollection.Name)]
public sealed class CommissioningTests(DesktopFixture fixture)
{
    [Fact]
    public Task Steps_are_shown_before_they_are_gone_through_and_the_page_begins_only_with_a_controller() => fixture.WithOperator(here =>
    {
        here.Show("Commissioning");
        Assert.Equal(8, Model(here).Steps.Count);
        Assert.All(Model(here).Steps, step => Assert.Equal(("", false), (step.State, step.IsCurrent)));
        Assert.False(here.Find<Button>("BeginKey").IsEffectivelyEnabled);
        Assert.False(here.Find<Button>("BreakOffKey").IsEffectivelyEnabled);
        here.Enter("CNCCONNECT", "sim:");
        Assert.True(here.Find<Button>("BeginKey").IsEffectivelyEnabled);
    });

    [Fact]
    public Task Buttons_answer_and_the_page_tells_where_it_stands() => fixture.WithOperator(here =>
    {
        here.Enter("CNCCONNECT", "sim:");
        here.Show("Commissioning");
        here.Click(here.Find<Button>("BeginKey"));
        here.WaitUntilIdle();
        Assert.False(here.Find<Button>("BeginKey").IsEffectivelyEnabled);
        Assert.Equal(["in progress", "", "", "", "", "", "", ""], States(here));
        foreach (var way in new[] { "Skip", "Skip", "Back", "Skip", "Skip", "Skip", "Go" }) Answer(here, way);
        Assert.Equal(["skipped", "skipped", "skipped", "skipped", "in progress", "", "", ""], States(here));

        Assert.Contains("Enter speed of the test moves", Model(here).Question, StringComparison.Ordinal);
        Assert.True(Model(here).IsTyped);
        here.Click(here.Find<Button>("KeepKey")); // the speed
        here.WaitUntilIdle();
        here.Enter("1000"); // counts
        Assert.Contains("Is the path clear", Model(here).Question, StringComparison.Ordinal);
        Assert.Equal(0.0, here.Commands.Machine.Status.MachinePosition!.Value.X);
        Answer(here, "Yes");
        here.Until(() => here.Commands.Machine.Status.MachinePosition!.Value.X == 1.0);
        here.Click(here.Find<Button>("BreakOffKey"));
        here.Until(() => here.Desk.Queue.Cancelled.IsCompleted);
        here.WaitUntilIdle();

        Assert.Equal(["skipped", "skipped", "skipped", "skipped", "", "", "", ""], States(here));
        Assert.Null(here.Desk.Prompt.Command);
        Assert.Equal(("", 0), (Model(here).Question, Model(here).Answers.Count));
        Assert.True(here.Find<Button>("BeginKey").IsEffectivelyEnabled);
    });

    [Fact]
    public Task A_question_of_another_command_has_no_answers_on_this_page() => fixture.WithOperator(here =>
    {
        here.Enter("CNCCONNECT", "sim:");
        here.Show("Commissioning");
        here.Enter("CNCZERO");
        Assert.Empty(Model(here).Answers);
        Assert.Equal("", Model(here).Question);
        here.Hands.Press(Key.Escape);
        here.WaitUntilIdle();
    });

    private static CommissioningModel Model(Operator here) => (CommissioningModel)here.Window.GetVisualDescendants().OfType<CommissioningView>().First().DataContext!;

    private static IEnumerable<string> States(Operator here) => Model(here).Steps.Select(step => step.State);

    private static void Answer(Operator here, string name)
    {
        here.Click(here.Find<ItemsControl>("AnswerList").GetVisualDescendants().OfType<Button>().First(button => button.Content as string == name));
        here.WaitUntilIdle();
    }
}
