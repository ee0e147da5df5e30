using Avalonia.Media;
using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.Core.Drawings;
using Engraver.Workbench.Commands.Editing;

namespace Engraver.App.Layers;

/// <summary>A layer with its switches and its colour; each runs the LAYER command.</summary>
public sealed class LayerRow(Layer layer, int curves, DesktopModel desk)
{
    /// <summary>The first nine colours of the colour index: red to white, dark and light grey.</summary>
    private const int StandardColours = 9;

    public string Name => layer.Name;

    public int Curves => curves;

    public bool On => layer.On;

    public bool Thawed => !layer.Frozen;

    public bool Locked => layer.Locked;

    public bool Plot => layer.Plot;

    /// <summary>False: nothing on the layer is cut.</summary>
    public bool IsCut => layer.CutByDefault;

    public RelayCommand SwitchOn { get; } = Switch(layer.On ? "OFF" : "ON", layer, desk);

    public RelayCommand SwitchThawed { get; } = Switch(layer.Frozen ? "Thaw" : "Freeze", layer, desk);

    public RelayCommand SwitchLocked { get; } = Switch(layer.Locked ? "Unlock" : "LOck", layer, desk);

    public RelayCommand SwitchPlot { get; } = Switch(layer.Plot ? "Noplot" : "Plot", layer, desk);

    public IBrush Colour { get; } = ColourChoice.BrushOf(layer.Colour);

    public string ColourText { get; } = ColourName.Format(layer.Colour);

    public IReadOnlyList<ColourChoice> Choices { get; } =
        [.. Enumerable.Range(1, StandardColours).Select(index => new ColourChoice(DrawingColour.FromCode62(index), name => _ = desk.Queue.RunAsync("LAYER", "Color", name, layer.Name, "")))];

    private static RelayCommand Switch(string option, Layer layer, DesktopModel desk) => new(() => _ = desk.Queue.RunAsync("LAYER", option, layer.Name, ""));
}
