namespace Engraver.App.Canvas.Interaction;

internal enum PointerButton
{
    Left,
    Middle,
    Right,
}
