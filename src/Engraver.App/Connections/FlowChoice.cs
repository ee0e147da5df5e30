using Engraver.App.Texts;
using Engraver.Galil.Links;

namespace Engraver.App.Connections;

/// <summary>A way of flow control to choose.</summary>
/// <param name="Word">As it stands in an address.</param>
public sealed record FlowChoice(SerialFlow Flow, string Word)
{
    public string Name => Text.Of("Flow." + Flow);

    public override string ToString() => Name;
}
