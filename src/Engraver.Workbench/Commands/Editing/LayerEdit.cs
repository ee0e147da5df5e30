using Engraver.Core.Drawings;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>The edited layers while LAYER runs: the document changes only at its end.</summary>
internal sealed class LayerEdit
{
    private const int MaxNameLength = 255;

    /// <summary>Characters that a layer name in DXF must not contain.</summary>
    private const string ForbiddenCharacters = "<>/\\\":;?*|,=`";

    private readonly List<Layer> _layers;
    private readonly List<(string From, string To)> _renamed = [];

    public LayerEdit(CommandContext context) => (_layers, Current) = ([.. context.Drawing.Layers], NameOf(context));

    public IReadOnlyList<Layer> Layers => _layers;

    /// <summary>Name of the current layer.</summary>
    public string Current { get; private set; }

    /// <summary>Whether a layer has this name, case-insensitive.</summary>
    public static bool IsNamed(Layer layer, string name) => layer.Name.Equals(name, StringComparison.OrdinalIgnoreCase);

    /// <summary>Error message if a layer does not exist; otherwise null.</summary>
    public string? UnknownLayerError(IEnumerable<string> names)
    {
        var unknown = names.Where(name => Find(name) is null).ToList();
        return unknown.Count == 0 ? null : Wording.Get("Layer.NotFound", string.Join(", ", unknown.Select(name => $"'{name}'")));
    }

    /// <summary>Why no layer of this name can be created and set: the name is invalid, or the layer is frozen; null if it can.</summary>
    public string? CreateError(string name) => Find(name) is null ? NameError(name) : SetCurrentError(name);

    /// <summary>Why this layer cannot be current: it does not exist or is frozen; null if it can.</summary>
    public string? SetCurrentError(string name) => UnknownLayerError([name]) ?? (GetLayer(name) is { Frozen: true } frozen ? Wording.Get("Layer.FrozenNotCurrent", frozen.Name) : null);

    /// <summary>Why this layer cannot be renamed: it does not exist or is layer 0; null if it can.</summary>
    public string? RenameSourceError(string name) => UnknownLayerError([name]) ?? (GetLayer(name).Name == CurrentLayer.DefaultName ? Wording.Get("Layer.NotRenamed", CurrentLayer.DefaultName) : null);

    /// <summary>Why this layer cannot get that name: it is invalid or already used; null if it can.</summary>
    public string? RenameTargetError(string name, string to) => NameError(to) ?? (Find(to) is { } other && other != Find(name) ? Wording.Get("Layer.NameTaken", _layers[other].Name) : null);

    /// <summary>Creates a layer unless it exists and makes it current. Precondition: <see cref="CreateError"/> is null.</summary>
    public void Create(string name)
    {
        if (Find(name) is null) _layers.Add(new Layer(name, On: true, Frozen: false, Plot: true));
        SetCurrent(name);
    }

    /// <summary>Sets the current layer. Precondition: <see cref="SetCurrentError"/> is null.</summary>
    public void SetCurrent(string name) => Current = GetLayer(name).Name;

    /// <summary>Renames a layer. Precondition: <see cref="RenameSourceError"/> and <see cref="RenameTargetError"/> are null.</summary>
    public void Rename(string name, string to)
    {
        var from = GetLayer(name).Name;
        _layers[Find(name)!.Value] = GetLayer(name) with { Name = to };
        if (Current == from) Current = to;
        _renamed.Add((from, to));
    }

    /// <summary>Changes the matching layers.</summary>
    public void Change(Predicate<Layer> isMeant, Func<Layer, Layer> change)
    {
        for (var index = 0; index < _layers.Count; index++)
        {
            if (isMeant(_layers[index])) _layers[index] = change(_layers[index]);
        }
    }

    /// <summary>Commits one undo step if something has changed. Settings that refer to a renamed layer are updated.</summary>
    public void Commit(CommandContext context)
    {
        var state = context.Document.Current;
        if (Layers.SequenceEqual(context.Drawing.Layers) && Current == NameOf(context)) return;
        var settings = state.Settings;
        if (_renamed.Count > 0) settings = settings with { Layers = settings.Layers is { } chosen ? Renamed(chosen) : null, SkippedLayers = Renamed(settings.SkippedLayers) };
        context.Commit(state with { Drawing = Layers.SequenceEqual(context.Drawing.Layers) ? state.Drawing : context.Drawing with { Layers = [.. Layers] }, Settings = settings, CurrentLayer = Current });
    }

    private static string NameOf(CommandContext context) => CurrentLayer.IndexOf(context.Drawing, context.Document.Current.CurrentLayer) is { } index ? context.Drawing.Layers[index].Name : context.Document.Current.CurrentLayer;

    private static string? NameError(string name) => name.Length is 0 or > MaxNameLength || name.Any(ForbiddenCharacters.Contains) ? Wording.Get("Layer.InvalidName", name, ForbiddenCharacters) : null;

    private int? Find(string name) => _layers.FindIndex(layer => IsNamed(layer, name)) is >= 0 and var index ? index : null;

    private Layer GetLayer(string name) => _layers[Find(name)!.Value];

    private IReadOnlyList<string> Renamed(IReadOnlyList<string> names) =>
        [.. names.Select(name => _renamed.Aggregate(name, (now, change) => now.Equals(change.From, StringComparison.OrdinalIgnoreCase) ? change.To : now))];
}
