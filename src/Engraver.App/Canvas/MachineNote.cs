using Avalonia.Controls;
using Avalonia.Layout;
using Avalonia.Media;

namespace Engraver.App.Canvas;

/// <summary>The note about an uncertain position, in the corner of the canvas.</summary>
internal sealed class MachineNote : Border
{
    private readonly TextBlock _text = new() { Name = "MachineNoteText", TextWrapping = TextWrapping.Wrap, FontSize = 12.0 };

    public MachineNote()
    {
        (Name, Child, IsHitTestVisible, IsVisible) = ("MachineNote", _text, false, false);
        (HorizontalAlignment, VerticalAlignment, MaxWidth) = (HorizontalAlignment.Left, VerticalAlignment.Top, 460.0);
        (Margin, Padding, BorderThickness, CornerRadius) = (new(10.0), new(8.0, 5.0), new(1.0), new(3.0));
        Bind(BackgroundProperty, this.GetResourceObservable("PanelBrush"));
        Bind(BorderBrushProperty, this.GetResourceObservable("WarningTextBrush"));
        _text.Bind(TextBlock.ForegroundProperty, this.GetResourceObservable("TextBrush"));
    }

    public void Show(string note) => (_text.Text, IsVisible) = (note, note.Length > 0);
}
