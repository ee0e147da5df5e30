using System.Globalization;
using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.App.Texts;
using Engraver.Core;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Machines;

namespace Engraver.App.HandMoves;

/// <summary>A work origin in the list.</summary>
public sealed record OriginRow(string Name, string Place, bool IsActive);
