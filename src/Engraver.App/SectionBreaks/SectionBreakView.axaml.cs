using Avalonia.Controls;
using Avalonia.Input;

namespace Engraver.App.SectionBreaks;

/// <summary>The question at a change of the tool or a stop between repeats, over the canvas.</summary>
public partial class SectionBreakView : UserControl
{
    public SectionBreakView()
    {
        InitializeComponent();
        Cursor = new Cursor(StandardCursorType.Arrow);
        PointerPressed += (_, e) => e.Handled = true; // not a click on the canvas
    }
}
