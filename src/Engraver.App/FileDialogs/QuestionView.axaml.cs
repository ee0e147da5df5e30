using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Threading;
using Avalonia.VisualTree;

namespace Engraver.App.FileDialogs;

/// <summary>The sheet of a question, below the machine strip, so that STOP stays visible.</summary>
public partial class QuestionView : UserControl
{
    public QuestionView()
    {
        InitializeComponent();
        AnswerList.GotFocus += (_, e) =>
        {
            if (e.Source is Button { DataContext: QuestionAnswer answer }) Model.Highlight(answer);
        };
    }

    private QuestionModel Model => (QuestionModel)DataContext!;

    /// <summary>Enter accepts an answer and Esc cancels; Tab moves between the answers; all other keys are ignored.</summary>
    /// <returns>True if the key was handled.</returns>
    public bool Press(KeyEventArgs e)
    {
        if (e.Key == Key.Escape) Model.Cancel();
        else if (e.Key == Key.Enter) Model.Accept();
        else return e.Source is TextBox && (Edits(e.Key) || e.KeyModifiers is not (KeyModifiers.None or KeyModifiers.Shift)); // the text box under the question must not receive it
        return true;
    }

    /// <summary>Letters of an answer: moves the focus to it.</summary>
    public void Type(string letters)
    {
        Model.Type(letters);
        FocusHighlighted();
    }

    private void FocusHighlighted() => AnswerList.ContainerFromItem(Model.Answers.First(answer => answer.IsHighlighted))?.GetVisualDescendants().OfType<Button>().FirstOrDefault()?.Focus();

    protected override void OnPropertyChanged(AvaloniaPropertyChangedEventArgs change)
    {
        ArgumentNullException.ThrowIfNull(change);
        base.OnPropertyChanged(change);
        if (change.Property == IsVisibleProperty && IsVisible) Dispatcher.UIThread.Post(FocusHighlighted, DispatcherPriority.Loaded);
    }

    private static bool Edits(Key key) => key is Key.Back or Key.Delete or Key.Left or Key.Right or Key.Up or Key.Down or Key.Home or Key.End;
}
