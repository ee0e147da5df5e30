using Avalonia.Controls;

namespace Engraver.App.CommandWindow;

/// <summary>The options of the prompt, to be clicked.</summary>
public partial class PromptOptions : UserControl
{
    public PromptOptions() => InitializeComponent();
}
