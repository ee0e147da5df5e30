using Avalonia;
using Avalonia.Controls;
using Avalonia.VisualTree;
using Engraver.App.Commissioning;

namespace Engraver.App.Tests.RealWindow;

/// <summary>The conversation of the commissioning page, recorded in the same window in memory: the pixels before each answer, and the position of the
/// answer's button.</summary>
internal sealed class AskedQuestions
{
    private readonly List<AskedQuestion> _asked = [];

    private AskedQuestions()
    {
    }

    /// <summary>Position of the tab of the page, and of its keys.</summary>
    public Point Tab { get; private set; }

    public Point Start { get; private set; }

    public Point Abort { get; private set; }

    public IReadOnlyList<AskedQuestion> All => _asked;

    /// <summary>Position of the list of steps.</summary>
    public PixelRect EndPlace { get; private set; }

    /// <summary>Pixels of the list of steps after the last answer, with the result of each: 0xRRGGBB, row by row.</summary>
    public int[] EndLook { get; private set; } = [];

    /// <param name="drawing">Opened in the window.</param>
    /// <param name="folder">The folder for written files.</param>
    /// <param name="answers">In order.</param>
    public static async Task<AskedQuestions> OfAsync(DesktopFixture fixture, string drawing, string folder, IReadOnlyList<GivenAnswer> answers)
    {
        var found = new AskedQuestions();
        await fixture.WithOperator(here =>
        {
            here.Hands.Resize(new Size(ShownDesktop.Size.Width, ShownDesktop.Size.Height));
            here.Open(drawing);
            here.Enter("CNCCONNECT", "sim:?speed=10");
            here.Show("Commissioning");
            found.Tab = here.MiddleOf(here.Window.GetVisualDescendants().OfType<ListBoxItem>().First(item => item.DataContext is Engraver.App.Tabs.PageTab { Key: "Commissioning" }));
            (found.Start, found.Abort) = (here.MiddleOf(here.Find<Button>("BeginKey")), here.MiddleOf(here.Find<Button>("BreakOffKey")));
            here.Click(here.Find<Button>("BeginKey"));
            here.WaitUntilIdle();
            foreach (var answer in answers) found.Answer(here, answer);
            found.EndPlace = PlaceOf(here, here.Find<ItemsControl>("CommissioningSteps"));
            found.EndLook = Look(here, found.EndPlace);
        }, workFolder: folder);
        return found;
    }

    private void Answer(Operator here, GivenAnswer answer)
    {
        here.Until(() => here.Desk.Prompt.Command is not null && (answer.Way == AnswerWay.Typed || ButtonOf(here, answer.Text) is not null)); // a busy computer shows the next question later
        here.WaitUntilIdle();
        var question = here.Find<TextBlock>("QuestionText");
        var place = PlaceOf(here, question);
        var button = answer.Way == AnswerWay.Typed ? (Point?)null : here.MiddleOf(ButtonOf(here, answer.Text)!);
        _asked.Add(new AskedQuestion(question.Text!, answer, button, place, Look(here, place)));
        if (button is { } at) here.Hands.Click(at);
        else
        {
            here.Hands.Type(answer.Text);
            here.Hands.Press(Avalonia.Input.Key.Enter);
        }

        here.Step();
        if (answer.Way == AnswerWay.ClickedThenStopped)
        {
            here.Until(() => here.Window.Model.Machine.State == "MOVING");
            here.Hands.Press(Avalonia.Input.Key.Pause);
        }

        here.WaitUntilIdle();
    }

    private static Button? ButtonOf(Operator here, string answer)
    {
        var page = here.Window.GetVisualDescendants().OfType<CommissioningView>().First();
        return page.GetVisualDescendants().OfType<Button>().FirstOrDefault(button => button.Content as string == answer);
    }

    private static PixelRect PlaceOf(Operator here, Control control)
    {
        var corner = control.TranslatePoint(default, here.Window)!.Value;
        return new PixelRect((int)corner.X, (int)corner.Y, (int)control.Bounds.Width, (int)control.Bounds.Height);
    }

    private static int[] Look(Operator here, PixelRect place)
    {
        var look = new int[place.Width * place.Height];
        for (var i = 0; i < look.Length; i++) look[i] = (int)(here.Hands.PixelAt(place.X + (i % place.Width), place.Y + (i / place.Width)).ToUInt32() & 0xFFFFFF);
        return look;
    }
}

/// <summary>A question of the page.</summary>
/// <param name="Button">Position of its button; null if the answer is typed.</param>
/// <param name="Place">Of its text in the window.</param>
/// <param name="Look">The pixels there, 0xRRGGBB, row by row.</param>
internal sealed record AskedQuestion(string Text, GivenAnswer Answer, Point? Button, PixelRect Place, int[] Look);

/// <summary>An answer of the operator.</summary>
/// <param name="Text">The text of a button, or the typed text; empty for Enter alone.</param>
internal sealed record GivenAnswer(string Text, AnswerWay Way)
{
    public static GivenAnswer Click(string text) => new(text, AnswerWay.Clicked);

    public static GivenAnswer Type(string text) => new(text, AnswerWay.Typed);
}

/// <summary>How an answer is given.</summary>
internal enum AnswerWay
{
    Clicked,
    Typed,

    /// <summary>STOP is pressed during the motion that the answer starts.</summary>
    ClickedThenStopped,
}
