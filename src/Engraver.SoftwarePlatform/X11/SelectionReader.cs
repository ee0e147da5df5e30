namespace Engraver.SoftwarePlatform.X11;

/// <summary>Reads one selection of another program (the clipboard, or what is being dragged), whole or in pieces, on the event thread.</summary>
internal sealed class SelectionReader(XConnection connection, nint helper, nint selection, nint property, nint incr)
{
    private Action<byte[]?>? _done;
    private IncrReceive? _pieces;

    /// <summary>Asks the owner. The answer is null when it has nothing of the kind. A newer question ends an older one with null.</summary>
    public void Ask(nint target, nint time, Action<byte[]?> done)
    {
        Finish(null);
        _done = done;
        Xlib.XConvertSelection(connection.Display, selection, target, property, helper, time);
    }

    public void OnNotify(ref XEvent notice)
    {
        if (notice.Selection != selection || _done is null) return;
        if (notice.AnswerProperty == XAtoms.None)
        {
            Finish(null);
            return;
        }

        var (type, bytes) = connection.TakeBytes(helper, property);
        if (type == incr) _pieces = new IncrReceive();
        else Finish(bytes);
    }

    /// <summary>A property of the helper window has a new value.</summary>
    public void OnPropertyNew(nint changed)
    {
        if (changed != property || _pieces is null) return;
        var (_, bytes) = connection.TakeBytes(helper, property);
        if (_pieces.Take(bytes)) Finish(_pieces.Bytes);
    }

    private void Finish(byte[]? bytes)
    {
        var done = _done;
        _done = null;
        _pieces = null;
        done?.Invoke(bytes);
    }
}
