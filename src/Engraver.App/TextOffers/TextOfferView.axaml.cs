using Avalonia.Controls;
using Avalonia.Input;

namespace Engraver.App.TextOffers;

/// <summary>The offer to engrave texts, over the canvas.</summary>
public partial class TextOfferView : UserControl
{
    public TextOfferView()
    {
        InitializeComponent();
        Cursor = new Cursor(StandardCursorType.Arrow);
        PointerPressed += (_, e) => e.Handled = true; // not a click on the canvas
    }
}
