using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.VisualTree;
using Engraver.TestKit;

namespace Engraver.App.Tests.StatusBar;

/// <summary>A long operation shows in the status bar what it is, its progress and how to end it; Esc ends it without changes.</summary>
[Collection(DesktopCollection.Name)]
public sealed class LongOperationTests(DesktopFixture fixture)
{
    [Fact]
    public async Task Planning_shows_itself_and_Esc_ends_it_and_REGEN_begins_it_again()
    {
        var clock = new ManualTimeProvider();
        await fixture.WithOperator(here =>
        {
            using var goOn = new ManualResetEventSlim();
            here.Commands.Derivation.Progress.Changed += Hold;
            here.Hands.Type("open");
            here.Hands.Press(Key.Enter);
            here.Until(() => here.Desk.Prompt.Command == "OPEN");
            here.Hands.Type("paper-001.dxf");
            here.Hands.Press(Key.Enter);
            var text = here.Find<TextBlock>("WorkText");
            here.Until(() => text.IsEffectivelyVisible);
            Assert.Equal("Planning: contours and their order, 10 % (Esc cancels)", text.Text);
            here.Show("Job");
            Assert.Contains(Hints(here), hint => hint.Text == "Planning the job: contours and their order.");
            var before = here.Commands.Document.Current;
            here.Hands.Press(Key.Escape);
            here.Until(() => !text.IsEffectivelyVisible);
            goOn.Set();
            here.Commands.Derivation.Progress.Changed -= Hold;
            here.WaitUntilIdle();

            Assert.True(here.Commands.Derivation.IsCancelled);
            Assert.Same(before, here.Commands.Document.Current);
            Assert.Null(here.Desk.Derived.Job);
            Assert.Contains(here.History, line => line.StartsWith("Planning cancelled; nothing was changed", StringComparison.Ordinal));
            Assert.Contains(Hints(here), hint => hint.Text == "Planning cancelled with Esc. REGEN plans the job again.");
            _ = here.Desk.SelectAsync(_ => [0], remove: false); // selecting starts nothing
            here.WaitUntilIdle();
            Assert.True(here.Commands.Derivation.IsCancelled);
            here.Enter("REGEN");
            here.Until(() => here.Desk.Derived.Job is not null);
            Assert.DoesNotContain(Hints(here), hint => hint.IsVisible);

            void Hold(object? sender, EventArgs e)
            {
                if (here.Commands.Derivation.Progress.Stage?.Key == "Chain") goOn.Wait(TimeSpan.FromSeconds(60));
            }
        }, clock: clock);
    }

    private static IEnumerable<TextBlock> Hints(Operator here) => here.Window.GetVisualDescendants().OfType<TextBlock>().Where(text => text.Name == "HintText");

    /// <summary>Esc ends other things first: typed text, a prompt or the selection.</summary>
    [Fact]
    public Task Esc_that_clears_a_selection_does_not_end_the_planning() => fixture.WithOperator(here =>
    {
        using var goOn = new ManualResetEventSlim();
        here.Open("paper-001.dxf");
        here.Commands.Document.Select([0], []);
        here.Commands.Derivation.Progress.Changed += Hold;
        here.Hands.Type("cncmaxerr 0.02 ");
        here.Until(() => here.Commands.Derivation.Progress.Stage?.Key == "Chain");
        here.Commands.Document.Select([0], []);
        here.Hands.Press(Key.Escape);
        here.Until(() => here.Commands.Document.Current.Selection.Count == 0);
        goOn.Set();
        here.WaitUntilIdle();

        Assert.False(here.Commands.Derivation.IsCancelled);
        Assert.Equal(0.02, here.Desk.Derived.Current.State.Settings.MaxErrorMm);
        here.Commands.Derivation.Progress.Changed -= Hold;

        void Hold(object? sender, EventArgs e)
        {
            if (here.Commands.Derivation.Progress.Stage?.Key == "Chain") goOn.Wait(TimeSpan.FromSeconds(60));
        }
    });

    /// <summary>OPEN waits for its drawing, which the test does not write.</summary>
    [Fact]
    public async Task A_command_at_work_is_named()
    {
        await fixture.WithOperator(here =>
        {
            using var folder = new Start.TemporaryDesktopFolder();
            var path = NamedPipe.Make(Path.Combine(folder.Path, "slow.dxf"));
            var writer = NamedPipe.WriterAsync(path);
            here.Enter("open");
            here.Hands.Type(path);
            here.Hands.Press(Key.Enter);
            var text = here.Find<TextBlock>("WorkText");
            here.Until(() => text.IsEffectivelyVisible && writer.IsCompleted);

            Assert.Equal("OPEN is running (Esc cancels)", text.Text);
            Assert.True(here.Find<ProgressBar>("WorkLine").IsIndeterminate);
            here.Hands.Press(Key.Escape);
            here.Until(() => text.Text == "Cancelling OPEN ...");
            writer.GetAwaiter().GetResult().Dispose();
            here.WaitUntilIdle();
            Assert.False(text.IsEffectivelyVisible);
        }, clock: new ManualTimeProvider());
    }
}
