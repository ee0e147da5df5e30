using Engraver.Core.Drawings;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>The layers while LAYER asks for more: nothing of the document changes before its end.</summary>
internal sealed class LayerEdit
{
    private const int LongestName = 255;

    /// <summary>Letters that no layer of a DXF has in its name.</summary>
    private const string Forbidden = "<>/\\\":;?*|,=`";

    private readonly List<(string From, string To)> _renamed = [];

    public LayerEdit(CommandContext context) => (Layers, Current) = ([.. context.Drawing.Layers], NameOf(context));

    public List<Layer> Layers { get; }

    /// <summary>Name of the current layer.</summary>
    public string Current { get; private set; }

    /// <summary>Makes a layer, where there is none of this name, and sets it.</summary>
    public void Make(string name)
    {
        if (Find(name) is null)
        {
            Check(name);
            Layers.Add(new Layer(name, On: true, Frozen: false, Plot: true));
        }

        Set(name);
    }

    /// <exception cref="CommandException">There is no such layer, or it is frozen.</exception>
    public void Set(string name)
    {
        var layer = Layers[Index(name)];
        Current = !layer.Frozen ? layer.Name : throw new CommandException(CommandFailure.Usage, Wording.Get("Layer.FrozenNotCurrent", layer.Name));
    }

    /// <exception cref="CommandException">There is no such layer, it is layer 0, or the new name is taken or not allowed.</exception>
    public void Rename(string name, string to)
    {
        var index = Index(name);
        var from = Layers[index].Name;
        if (from == CurrentLayer.First) throw new CommandException(CommandFailure.Usage, Wording.Get("Layer.NotRenamed", from));
        Check(to);
        if (Find(to) is { } other && other != index) throw new CommandException(CommandFailure.Usage, Wording.Get("Layer.NameTaken", Layers[other].Name));
        Layers[index] = Layers[index] with { Name = to };
        if (Current == from) Current = to;
        _renamed.Add((from, to));
    }

    /// <summary>One document step, where something has changed. Settings that name a renamed layer name it anew.</summary>
    public void Take(CommandContext context)
    {
        var state = context.Document.Current;
        if (Layers.SequenceEqual(context.Drawing.Layers) && Current == NameOf(context)) return;
        var settings = state.Settings;
        if (_renamed.Count > 0) settings = settings with { Layers = settings.Layers is { } chosen ? Renamed(chosen) : null, SkippedLayers = Renamed(settings.SkippedLayers) };
        context.Take(state with { Drawing = Layers.SequenceEqual(context.Drawing.Layers) ? state.Drawing : context.Drawing with { Layers = [.. Layers] }, Settings = settings, CurrentLayer = Current });
    }

    private static string NameOf(CommandContext context) => CurrentLayer.IndexOf(context.Drawing, context.Document.Current.CurrentLayer) is { } index ? context.Drawing.Layers[index].Name : context.Document.Current.CurrentLayer;

    private static void Check(string name)
    {
        if (name.Length is 0 or > LongestName || name.Any(Forbidden.Contains)) throw new CommandException(CommandFailure.Usage, Wording.Get("Layer.NoName", name, Forbidden));
    }

    private int? Find(string name) => Layers.FindIndex(layer => layer.Name.Equals(name, StringComparison.OrdinalIgnoreCase)) is >= 0 and var index ? index : null;

    private int Index(string name) => Find(name) ?? throw new CommandException(CommandFailure.Usage, Wording.Get("Layer.DrawingHasNoLayer", $"'{name}'"));

    private IReadOnlyList<string> Renamed(IReadOnlyList<string> names) =>
        [.. names.Select(name => _renamed.Aggregate(name, (now, change) => now.Equals(change.From, StringComparison.OrdinalIgnoreCase) ? change.To : now))];
}
