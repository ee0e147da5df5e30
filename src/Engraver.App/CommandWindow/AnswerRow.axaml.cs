using Avalonia.Controls;

namespace Engraver.App.CommandWindow;

/// <summary>The last message, or the options of the prompt, while the history is hidden. It takes its room from the pages, so that the canvas does not
/// move.</summary>
public partial class AnswerRow : UserControl
{
    public AnswerRow() => InitializeComponent();
}
