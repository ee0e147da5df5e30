using Avalonia.Media;
using Engraver.App.Binding;
using Engraver.App.Canvas.Colours;
using Engraver.Core.Drawings;
using Engraver.Workbench.Commands.Editing;

namespace Engraver.App.Layers;

/// <summary>A colour for a layer.</summary>
/// <param name="colour">An index or a true colour.</param>
/// <param name="take">Sets the colour of the layer; the name is the English one, which LAYER accepts in every language.</param>
public sealed class ColourChoice(DrawingColour colour, Action<string> take)
{
    /// <summary>The colour shown for index 7 in the list of colours.</summary>
    private const uint White = 0xFFFFFFFF;

    /// <summary>In the operator's language.</summary>
    public string Name { get; } = ColourName.Format(colour);

    public IBrush Brush { get; } = BrushOf(colour);

    public RelayCommand Choose { get; } = new(() => take(ColourName.FormatInEnglish(colour)));

    public static IBrush BrushOf(DrawingColour colour) =>
        new SolidColorBrush(Color.FromUInt32(colour.Rgb is { } rgb ? 0xFF000000 | rgb : AciPalette.ColourOf(colour.OrForeground().Index!.Value, White)));
}
