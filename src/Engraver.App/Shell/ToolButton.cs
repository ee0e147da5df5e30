using System.Windows.Input;
using Avalonia.Media;

namespace Engraver.App.Shell;

/// <summary>A key of the tool column.</summary>
/// <param name="Command">The command it runs.</param>
/// <param name="EndsGroup">True: a line follows.</param>
public sealed record ToolButton(string Command, Geometry Icon, string Tip, ICommand Act, bool EndsGroup);
