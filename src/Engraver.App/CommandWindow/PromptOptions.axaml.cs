using Avalonia.Controls;

namespace Engraver.App.CommandWindow;

/// <summary>The options of the prompt as buttons.</summary>
public partial class PromptOptions : UserControl
{
    public PromptOptions() => InitializeComponent();
}
