using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.Core.Drawings;

namespace Engraver.App.Layers;

/// <summary>The layers of the drawing.</summary>
public sealed class LayersModel : ObservableObject
{
    private readonly DesktopModel _desk;
    private Drawing? _shown;

    public LayersModel(DesktopModel desk)
    {
        _desk = desk;
        desk.Notifications.Changed += Refresh;
        Refresh();
    }

    public IReadOnlyList<LayerRow> Layers { get; private set; } = [];

    public bool IsEmpty => Layers.Count == 0;

    private void Refresh()
    {
        var drawing = _desk.Session.Document.Current.Drawing;
        if (ReferenceEquals(drawing, _shown)) return;
        _shown = drawing;
        Layers = drawing is null ? [] : Rows(drawing);
        OnPropertyChanged(null);
    }

    private List<LayerRow> Rows(Drawing drawing)
    {
        var curves = new int[drawing.Layers.Count];
        for (var index = 0; index < drawing.Entities.Count; index++) curves[drawing.Entities[index].Layer]++;
        return [.. drawing.Layers.Select((layer, index) => new LayerRow(layer, curves[index], _desk))];
    }
}
