// What each key of the table does.
#include "operator.h"
#include "selection.h"

namespace ping_pong_sim
{
using ping_pong::Action;
using ping_pong::Group;

void Operator::obey(const ping_pong::KeyEntry& entry)
{
  const SimStatus* status = link_.status();
  switch (entry.action)
  {
    case Action::Select:
      select(entry.group);
      break;
    case Action::Move:
    case Action::Turn:
      held_.press(entry.key, wallSeconds());
      wishChanged();
      break;
    case Action::Pause:
      note(link_.setPaused(status == nullptr || !status->paused));
      break;
    case Action::Step:
      if (status != nullptr && !status->paused) note(link_.setPaused(true));
      note(link_.step(params_.step));
      break;
    case Action::Reset:
      note(link_.reset());
      break;
    case Action::Serve:
      note(match_.score() != nullptr ? match_.toss() : link_.launch(params_.shot));
      break;
    case Action::NewMatch:
      note(match_.newMatch());
      break;
    case Action::Level:
      note(match_.changeLevel(entry.sign));
      break;
    case Action::Help:
      state_.help = !state_.help;
      break;
    case Action::Tool:
    case Action::View:
      break;  // the window's own
  }
}

void Operator::select(Group group)
{
  const SimStatus* status = link_.status();
  if (status == nullptr) return;
  std::vector<std::string> names = members(*status, group);
  if (group == Group::Paddles && !names.empty())
  {
    if (paddle_states_.paddles.empty()) return;  // where they stand is told in a moment
    putFirst(ownPaddle(), names);
  }
  if (names.empty())
  {
    if (!state_.selected.empty()) note("this scene has none of these");
    return;
  }
  state_.selected = nextOf(names, state_.selected);
  steady_.stop();
  paddle_.take(isPaddle(*status, state_.selected) ? state_.selected : "");
  wishChanged();
}

void Operator::wishChanged()
{
  const ping_pong::Wish wish = gliding() ? held_.wish() : ping_pong::Wish();
  if (!wish.isZero() && state_.selected == play_.paddle()) play_.release();  // the keys have it, until the mouse moves
  if (paddle_.wish(wish, axes(), params_.glide)) awaits_paddle_ = true;
}

void Operator::moveSteadily(double now)
{
  const ping_pong::Wish wish = held_.wish();
  if (wish.isZero() || state_.selected.empty() || gliding())
    steady_.stop();
  else
    note(steady_.go(link_, state_.selected, wish, axes(), params_.glide, now));
}
}  // namespace ping_pong_sim
