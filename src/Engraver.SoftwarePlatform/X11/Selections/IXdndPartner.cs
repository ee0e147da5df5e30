using Avalonia.Input.Raw;

namespace Engraver.SoftwarePlatform.X11.Selections;

/// <summary>The two partners of a drag: the program that drags, and the window below the pointer.</summary>
internal interface IXdndPartner
{
    /// <summary>Requests the files from the source; the reply comes through <see cref="XdndSession.FilesArrived"/>.</summary>
    void RequestFiles(nint time);

    /// <summary>Passes the position (pixels of the root window) to the window; its reply comes through <see cref="XdndSession.Answer"/>.</summary>
    void SendToWindow(RawDragEventType type, int rootX, int rootY, IReadOnlyList<string> files);

    void SendStatus(nint source, bool accepted);

    void SendFinished(nint source, bool accepted);
}
