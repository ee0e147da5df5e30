namespace Engraver.Core.Operations;

/// <summary>Kinds of tools.</summary>
public enum ToolKind
{
    Endmill,
    Ball,
    Engraver,
    Drill,
    Laser,
}
