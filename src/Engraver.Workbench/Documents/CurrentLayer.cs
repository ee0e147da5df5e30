using Engraver.Core.Drawings;

namespace Engraver.Workbench.Documents;

/// <summary>The layer on which new objects are drawn: CLAYER, otherwise layer 0.</summary>
internal static class CurrentLayer
{
    /// <summary>The layer that every drawing has in AutoCAD, and the current one of a drawing that was just opened.</summary>
    public const string DefaultName = "0";

    /// <summary>Index of the layer with this name, case-insensitive; null if there is none.</summary>
    public static int? IndexOf(Drawing drawing, string name)
    {
        for (var index = 0; index < drawing.Layers.Count; index++)
        {
            if (drawing.Layers[index].Name.Equals(name, StringComparison.OrdinalIgnoreCase)) return index;
        }

        return null;
    }

    /// <summary>The index of the layer for new objects, and the drawing with that layer: layer 0 is added if the drawing has neither it nor the current
    /// layer.</summary>
    /// <param name="state">Its drawing must be open.</param>
    public static (Drawing Drawing, int Layer) FindOrAdd(DocumentState state)
    {
        var drawing = state.Drawing ?? throw new ArgumentException("No drawing is open.", nameof(state));
        if ((IndexOf(drawing, state.CurrentLayer) ?? IndexOf(drawing, DefaultName)) is { } layer) return (drawing, layer);
        return (drawing with { Layers = [.. drawing.Layers, new Layer(DefaultName, On: true, Frozen: false, Plot: true)] }, drawing.Layers.Count);
    }
}
