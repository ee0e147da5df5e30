using Avalonia.Controls;

namespace Engraver.App.CommandWindow;

/// <summary>What was said last, or the options of the prompt, while the history is hidden. It takes its room from the pages, so that the canvas does not
/// move.</summary>
public partial class AnswerRow : UserControl
{
    public AnswerRow() => InitializeComponent();
}
