namespace Engraver.Core.Operations;

/// <summary>Direction of a profile or pocket, for a clockwise spindle.</summary>
public enum CutDirection
{
    /// <summary>As the order of cutting has it.</summary>
    Any,

    /// <summary>The wall that remains is on the right: outside clockwise, holes counter-clockwise.</summary>
    Climb,

    /// <summary>The wall that remains is on the left.</summary>
    Conventional,
}
