using Engraver.SoftwarePlatform.X11.Protocol;

namespace Engraver.SoftwarePlatform.X11.Selections;

/// <summary>Reads one selection of another program (the clipboard, or what is being dragged), whole or in pieces, on the event thread.</summary>
internal sealed class SelectionReader(XConnection connection, nint helper, nint selection, nint property, nint incr)
{
    private Action<byte[]?>? _done;
    private Action? _onPiece;
    private IncrReceive? _pieces;
    private nint _target;

    /// <summary>Requests the data from the owner. The reply is null if it has none of the kind. A newer request ends an older one with null.</summary>
    /// <param name="heard">Called when a piece of a long reply has arrived.</param>
    public void Request(nint target, nint time, Action<byte[]?> done, Action? heard = null)
    {
        Finish(null);
        (_target, _done, _onPiece) = (target, done, heard);
        Xlib.XConvertSelection(connection.Display, selection, target, property, helper, time);
    }

    public void OnNotify(ref XEvent notice)
    {
        if (notice.Selection != selection || _done is null || notice.Target != _target) return; // a reply to an older request, which comes too late
        if (notice.AnswerProperty == XAtoms.None)
        {
            Finish(null);
            return;
        }

        var (type, bytes) = connection.TakeBytes(helper, property);
        if (type != incr) Finish(bytes);
        else
        {
            _pieces = new IncrReceive();
            _onPiece?.Invoke();
        }
    }

    /// <summary>A property of the helper window has a new value.</summary>
    public void OnPropertyNew(nint changed)
    {
        if (changed != property || _pieces is null) return;
        var (_, bytes) = connection.TakeBytes(helper, property);
        _onPiece?.Invoke();
        if (_pieces.Take(bytes)) Finish(_pieces.Bytes);
    }

    private void Finish(byte[]? bytes)
    {
        var done = _done;
        (_done, _onPiece, _pieces) = (null, null, null);
        done?.Invoke(bytes);
    }
}
