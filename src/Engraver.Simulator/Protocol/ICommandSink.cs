namespace Engraver.Simulator.Protocol;

/// <summary>What a handle needs from the controller: execution of its commands and accounting of their time.</summary>
internal interface ICommandSink
{
    /// <summary>Executes one command; returns the reply with its prompt, valid until the next command, or nothing when no answer is to be sent.</summary>
    ReadOnlySpan<char> Execute(Handle handle, ReadOnlySpan<char> text);

    /// <summary>Refuses text that never became a command, for example a line that is too long.</summary>
    string? Refuse(Handle handle, int code);

    /// <summary>One line of a download; false when it is bad.</summary>
    bool StoreLine(string line);

    string? EndDownload(bool failed);

    string? StoreArray(Handle handle, Action store);

    /// <summary>Called for every byte received: on the serial line it takes its time, is echoed and may interrupt the program.</summary>
    /// <returns>False when it is data for the program and no part of a command (CI).</returns>
    bool Arrived(Handle handle, byte value);

    /// <summary>Called when the reply was sent: time passes.</summary>
    void Answered(Handle handle, int replyLength);

    /// <summary>Sends bytes to the client of a handle.</summary>
    void Deliver(Handle handle, ReadOnlySpan<byte> bytes);

    void Closed(Handle handle);
}
