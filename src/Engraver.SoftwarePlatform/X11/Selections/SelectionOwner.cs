using System.Text;
using Engraver.SoftwarePlatform.X11.Protocol;

namespace Engraver.SoftwarePlatform.X11.Selections;

/// <summary>This program's text on the clipboard: replies to other programs on the event thread, also while the user interface is busy.</summary>
internal sealed unsafe class SelectionOwner(XConnection connection, XAtoms atoms, nint helper)
{
    /// <summary>Larger texts are sent in pieces, bytes. Well below the server's longest request (256 KiB at least).</summary>
    public const int PieceLength = 64 * 1024;

    private readonly Dictionary<(nint Window, nint Property), (IncrSend Send, nint Type)> _sending = [];
    private byte[] _utf8 = [];
    private nint _since;
    private volatile bool _owns;

    public bool Owns => _owns;

    public void Own(string text, nint time)
    {
        _utf8 = Encoding.UTF8.GetBytes(text);
        _since = time;
        Xlib.XSetSelectionOwner(connection.Display, atoms.Clipboard, helper, time);
        _owns = Xlib.XGetSelectionOwner(connection.Display, atoms.Clipboard) == helper;
    }

    public void Disown(nint time)
    {
        if (_owns) Xlib.XSetSelectionOwner(connection.Display, atoms.Clipboard, 0, time);
        OnCleared();
    }

    /// <summary>Queries the server whether this program owns the clipboard, because the event that another program took it may be pending. On the event
    /// thread.</summary>
    public bool StillOwns() => _owns && Xlib.XGetSelectionOwner(connection.Display, atoms.Clipboard) == helper;

    /// <summary>Another program took the clipboard; this program may have taken it back meanwhile.</summary>
    public void OnCleared()
    {
        if (StillOwns()) return;
        _owns = false;
        _utf8 = [];
    }

    public void OnRequest(ref XEvent request)
    {
        var property = request.RequestProperty != XAtoms.None ? request.RequestProperty : request.RequestTarget; // as old programs ask
        var answered = _owns && request.RequestSelection == atoms.Clipboard && Answer(request.Requestor, property, request.RequestTarget);
        var notice = new XEvent
        {
            Type = XEventType.SelectionNotify, Window = request.Requestor, Selection = request.RequestSelection, Target = request.RequestTarget,
            AnswerProperty = answered ? property : XAtoms.None, AnswerTime = request.RequestTime,
        };
        Xlib.XSendEvent(connection.Display, request.Requestor, 0, 0, &notice);
    }

    /// <summary>The reader has taken a piece: sends the next one.</summary>
    public void OnPropertyDeleted(nint window, nint property)
    {
        if (!_sending.TryGetValue((window, property), out var transfer)) return;
        connection.SetBytes(window, property, transfer.Type, transfer.Send.NextPiece().Span);
        if (transfer.Send.IsDone) OnGone(window);
    }

    /// <summary>The reader's window was destroyed, or the transfer is complete.</summary>
    public void OnGone(nint window)
    {
        foreach (var transfer in _sending.Keys.Where(key => key.Window == window).ToList()) _sending.Remove(transfer);
    }

    private bool Answer(nint window, nint property, nint target)
    {
        if (target == atoms.Targets)
        {
            connection.SetLongs(window, property, XAtoms.Atom, atoms.Targets, atoms.Timestamp, atoms.Utf8String, atoms.TextPlainUtf8, atoms.TextPlain, atoms.Text, XAtoms.String);
            return true;
        }

        if (target == atoms.Timestamp)
        {
            connection.SetLongs(window, property, XAtoms.Integer, _since);
            return true;
        }

        return AnswerText(window, property, target);
    }

    private bool AnswerText(nint window, nint property, nint target)
    {
        if (target == XAtoms.String) Send(window, property, target, Encoding.Latin1.GetBytes(Encoding.UTF8.GetString(_utf8)));
        else if (target == atoms.Text) Send(window, property, atoms.Utf8String, _utf8);
        else if (target == atoms.Utf8String || target == atoms.TextPlainUtf8 || target == atoms.TextPlain) Send(window, property, target, _utf8);
        else return false;
        return true;
    }

    private void Send(nint window, nint property, nint type, byte[] bytes)
    {
        if (bytes.Length <= PieceLength)
        {
            connection.SetBytes(window, property, type, bytes);
            return;
        }

        _sending[(window, property)] = (new IncrSend(bytes, PieceLength), type);
        if (window != helper) Xlib.XSelectInput(connection.Display, window, XEventMask.PropertyChange | XEventMask.StructureNotify);
        connection.SetLongs(window, property, atoms.Incr, bytes.Length);
    }
}
