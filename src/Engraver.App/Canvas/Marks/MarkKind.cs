namespace Engraver.App.Canvas.Marks;

/// <summary>Signs that keep their size on the screen whatever the zoom. Each kind has a shape of its own, so that colour alone never carries the meaning.</summary>
internal enum MarkKind : byte
{
    /// <summary>A number beside an arrow in the direction of travel.</summary>
    Order,

    /// <summary>A small ring.</summary>
    Start,

    /// <summary>A ring with a cross in it.</summary>
    Finding,

    /// <summary>A ring with a long upright cross: the work origin.</summary>
    Origin,
}
