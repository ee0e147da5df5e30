using Engraver.Core.Geometry;

namespace Engraver.App.Canvas.Interaction;

internal enum PointerButton
{
    Left,
    Middle,
    Right,
}
